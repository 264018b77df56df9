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

/** What a control needs to know of one field. */
function fieldFacts(schema) {
  const facts = {
    choices: schema.enum,
    minimum: schema.minimum,
    maximum: schema.maximum,
    step: schema['x-step'],
    unit: schema['x-unit'],
    description: schema.description,
  };
  return Object.fromEntries(Object.entries(facts).filter(([, value]) => value !== undefined));
}

async function writeSceneFields() {
  const scene = JSON.parse(await readFile(`${schemaFolder}scene.schema.json`, 'utf8'));
  const fields = {};
  for (const group of ['camera', 'surface', 'lens', 'light', 'background']) {
    for (const [name, schema] of Object.entries(scene.definitions[group].properties)) {
      fields[`${group}.${name}`] = fieldFacts(schema);
    }
  }
  fields['filters'] = { maximum: scene.definitions.filters.maxItems };
  const text = `${BANNER}export const SCENE_FIELDS = ${JSON.stringify(fields, null, 2)} as const;\n`;
  await writeFile(`${outputFolder}scene_fields.ts`, text);
}

await mkdir(outputFolder, { recursive: true });
await Promise.all([writeTypes(), writeSceneFields()]);
