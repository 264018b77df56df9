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

const FIRST_STYLE = 'flagship';
export const styles = readdirSync(styleFolder)
  .map((name) => readJson(new URL(name, styleFolder)))
  .sort((a, b) => Number(b.name === FIRST_STYLE) - Number(a.name === FIRST_STYLE));

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
    .filter(([key]) => key !== 'name')
    .map(describeParameter);
  return { name, title, description, parameters };
}

export const modules = Object.fromEntries(
  ['shading', 'filter', 'lens_shape'].map((kind) => [
    kind,
    Object.entries(moduleDefinitions[kind]).map(describeModule),
  ]),
);
