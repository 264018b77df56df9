// Writes src/protocol/generated/ from protocol/schema: the types of all messages and documents, and
// what the scene's own fields may be (choices, ranges), so that no name, range or choice of the
// protocol is typed by hand.
import { compile } from 'json-schema-to-typescript';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';

const schemaFolder = fileURLToPath(new URL('../../protocol/schema/', import.meta.url));
const outputFolder = fileURLToPath(new URL('../src/protocol/generated/', import.meta.url));

const ROOT = {
  title: 'Protocol',
  type: 'object',
  properties: {
    client: { $ref: 'client-message.schema.json' },
    server: { $ref: 'server-message.schema.json' },
  },
  required: ['client', 'server'],
  additionalProperties: false,
};

const BANNER = '// Generated from protocol/schema by `npm run generate`.\n';

async function writeTypes() {
  const types = await compile(ROOT, 'Protocol', {
    cwd: schemaFolder,
    bannerComment: BANNER,
    format: false,
  });
  await writeFile(`${outputFolder}protocol.ts`, types);
}

/** What kind of control a field has; nothing where it has none of its own. */
function kindOf({ $ref: reference = '', enum: choices, type }) {
  if (choices) return 'choice';
  if (reference.endsWith('#/definitions/colour')) return 'colour';
  return { number: 'number', integer: 'number', boolean: 'boolean' }[type];
}

/** What a control needs to know of one field; of a point, what holds for each of its numbers. */
function fieldFacts(schema, definitions) {
  const point = schema.$ref === '#/definitions/position_mm' ? definitions.position_mm.items : {};
  const number = { ...point, ...schema };
  const facts = {
    kind: kindOf(schema),
    choices: schema.enum,
    minimum: number.minimum,
    maximum: number.maximum,
    step: number['x-step'],
    unit: number['x-unit'],
    default: schema.default,
    description: schema.description,
  };
  return Object.fromEntries(Object.entries(facts).filter(([, value]) => value !== undefined));
}

/** Follows $refs, also into another file; what is said beside a $ref wins. */
function resolved(schemas, { $ref: reference, ...said }, file) {
  if (reference === undefined) return { node: said, file };
  const [other, pointer = ''] = reference.split('#');
  const target_file = other === '' ? file : other.replace('.schema.json', '');
  const target = pointer
    .split('/')
    .slice(1)
    .reduce((node, token) => node[token], schemas[target_file]);
  const { node, file: found_in } = resolved(schemas, target, target_file);
  return { node: { ...node, ...said }, file: found_in };
}

/** Every field of the scene with what the schema says it belongs to; a module is one field. */
function scenePaths(schemas, schema, file, path) {
  const { node, file: found_in } = resolved(schemas, schema, file);
  const belongs_to = node['x-belongs-to'];
  if (belongs_to !== undefined)
    return [{ path, belongs_to, optional: node['x-optional'] === true }];
  if (!node.properties) throw new Error(`the schema does not say what belongs to ${path}`);
  return Object.entries(node.properties).flatMap(([name, child]) =>
    scenePaths(schemas, child, found_in, [...path, name]),
  );
}

/** The scene's own fields that one part of a picture's making alone reads. */
const groupsReadBy = (scene, reader) =>
  Object.entries(scene.properties)
    .filter(([, node]) => node['x-read-by'] === reader)
    .map(([name]) => name);

const readSchema = async (name) =>
  JSON.parse(await readFile(`${schemaFolder}${name}.schema.json`, 'utf8'));

async function writeSceneFields() {
  const names = ['scene', 'modules', 'client-message', 'style'];
  const [scene, modules, client, style] = await Promise.all(names.map(readSchema));
  const fields = {};
  for (const group of [
    'camera',
    'preparation',
    'surface',
    'normals',
    'occlusion',
    'shadow',
    'lens',
    'wall',
    'light',
    'background',
    'window',
  ]) {
    for (const [name, schema] of Object.entries(scene.definitions[group].properties)) {
      fields[`${group}.${name}`] = fieldFacts(schema, scene.definitions);
    }
  }
  fields['filters'] = { maximum: scene.definitions.filters.maxItems };
  const side = fieldFacts(client.definitions.preview_side_px, {});
  const constants = {
    SCENE_FIELDS: fields,
    SCENE_PATHS: scenePaths({ scene, modules }, scene, 'scene', []),
    SCENE_GROUPS: Object.keys(scene.properties),
    SLICES_GROUPS: groupsReadBy(scene, 'slices'),
    SCENE_VERSION: scene.properties.version.const,
    STYLE_FIELDS: Object.keys(style.properties),
    PREVIEW_SIDE_PX: side,
  };
  const lines = Object.entries(constants).map(
    ([name, value]) => `export const ${name} = ${JSON.stringify(value, null, 2)} as const;\n`,
  );
  await writeFile(`${outputFolder}scene_fields.ts`, BANNER + lines.join(''));
}

await mkdir(outputFolder, { recursive: true });
await Promise.all([writeTypes(), writeSceneFields()]);
