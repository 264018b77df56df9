// The protocol's schemas, for checking messages and for describing modules.
import Ajv from 'ajv';
import { readdirSync, readFileSync } from 'node:fs';

const folder = new URL('../../../protocol/schema/', import.meta.url);
const styleFolder = new URL('../../../server/styles/', import.meta.url);
const readJson = (url) => JSON.parse(readFileSync(url, 'utf8'));

export const schemas = new Map(
  readdirSync(folder).map((name) => [name, readJson(new URL(name, folder))]),
);

const ajv = new Ajv({ strict: false, schemas: [...schemas.values()] });
const schemaId = (name) => schemas.get(name).$id;
export const validateClientMessage = ajv.getSchema(schemaId('client-message.schema.json'));
export const validateScene = ajv.getSchema(schemaId('scene.schema.json'));

export const styleFiles = readdirSync(styleFolder).map((name) =>
  readJson(new URL(name, styleFolder)),
);

const moduleDefinitions = schemas.get('modules.schema.json').definitions;

function typeOf(schema) {
  if (schema.$ref) return 'colour';
  return schema.enum ? 'choice' : schema.type;
}

function describeParameter([name, schema]) {
  const optional = {
    minimum: schema.minimum,
    maximum: schema.maximum,
    step: schema['x-step'],
    unit: schema['x-unit'],
    choices: schema.enum,
  };
  const present = Object.fromEntries(
    Object.entries(optional).filter(([, value]) => value !== undefined),
  );
  const { title, description } = schema;
  return {
    name,
    title,
    description,
    type: typeOf(schema),
    default: schema.default,
    level: schema['x-level'],
    ...present,
  };
}

function describeModule([name, { title, description, properties }]) {
  const parameters = Object.entries(properties)
    .filter(([key, schema]) => key !== 'name' && !schema['x-alias'])
    .map(describeParameter);
  return { name, title, description, parameters };
}

const describeKind = (kind) => Object.entries(moduleDefinitions[kind]).map(describeModule);

const SECTION_CORNERS = 33;
const halfCircle = Array.from({ length: SECTION_CORNERS }, (_, index) => {
  const angle = (Math.PI * index) / (SECTION_CORNERS - 1);
  return [Math.sin(angle), -Math.cos(angle)];
});

/** The stand-in draws no other lens. */
const lensShapes = describeKind('lens_shape')
  .filter(({ name }) => name === 'sphere')
  .map((shape) => ({ ...shape, outline: { profile: halfCircle, round: true } }));

export const modules = {
  shading: describeKind('shading'),
  filter: describeKind('filter'),
  lens_shape: lensShapes,
};

/** The module's real parameters: another name of one counts `factor` times. */
export function withoutAliases(kind, module) {
  const { properties } = moduleDefinitions[kind][module.name];
  const real = ([key, value]) => {
    const alias = properties[key]?.['x-alias'];
    if (!alias) return [key, value];
    const scaled = value * alias.factor;
    return [alias.of, alias.whole ? Math.floor(scaled) : scaled];
  };
  return Object.fromEntries(Object.entries(module).map(real));
}

/** What a field of the scene is where nothing says it. */
export const sceneDefault = (group, field) =>
  schemas.get('scene.schema.json').definitions[group].properties[field].default;

/** The group's own fields that belong to the look. */
export const lookFields = (group) =>
  Object.entries(schemas.get('scene.schema.json').definitions[group].properties)
    .filter(([, schema]) => schema['x-belongs-to'] === 'look')
    .map(([name]) => name);
