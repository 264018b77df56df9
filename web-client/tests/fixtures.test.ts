// The protocol's fixtures, read with another validator than the server's; and its channel
// description.
import { fromFile, Parser } from '@asyncapi/parser';
import Ajv from 'ajv';
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

const protocol_folder = fileURLToPath(new URL('../../protocol/', import.meta.url));
const style_folder = fileURLToPath(new URL('../../server/styles/', import.meta.url));
const readJson = (path: string): unknown => JSON.parse(readFileSync(path, 'utf8'));
const filesOf = (folder: string): string[] =>
  readdirSync(folder).filter((name) => name.endsWith('.json'));

const SCHEMA_ENDING = '.schema.json';
const schema_names = filesOf(`${protocol_folder}schema`).map((name) =>
  name.slice(0, -SCHEMA_ENDING.length),
);

const schemas = schema_names.map(
  (name) => readJson(`${protocol_folder}schema/${name}${SCHEMA_ENDING}`) as { $id: string },
);
const ajv = new Ajv({
  strict: true,
  strictTypes: false,
  allErrors: false,
  schemas,
  keywords: ['x-unit', 'x-step', 'x-level', 'x-kind', 'x-alias', 'x-axis'].concat(
    'x-belongs-to',
    'x-optional',
    'x-read-by',
  ),
});

function validates(schema_name: string, document: unknown): boolean {
  const schema = schemas[schema_names.indexOf(schema_name)];
  const validate = schema && ajv.getSchema(schema.$id);
  if (!validate) throw new Error(`no schema ${schema_name}`);
  return validate(document) === true;
}

/** A valid fixture's name begins with its schema's; the longest such name is meant. */
function schemaOf(fixture: string): string {
  const [name] = schema_names
    .filter((schema) => fixture.startsWith(`${schema}-`))
    .sort((a, b) => b.length - a.length);
  if (!name) throw new Error(`${fixture} names no schema`);
  return name;
}

interface InvalidFixture {
  readonly schema: string;
  readonly document?: unknown;
  readonly text?: string;
  readonly semantic?: boolean;
  readonly error: { readonly code: string };
}

/** Text that JSON has no word for, or that JavaScript reads as Infinity. */
function isRefusedText(text: string): boolean {
  try {
    const value: unknown = JSON.parse(text);
    return (
      JSON.stringify(value) !==
      JSON.stringify(value, (_key, part: unknown) =>
        part === Infinity || part === -Infinity ? 'not finite' : part,
      )
    );
  } catch {
    return true;
  }
}

describe('valid fixtures', () => {
  it.each(filesOf(`${protocol_folder}fixtures/valid`))('%s', (name) => {
    expect(
      validates(schemaOf(name), readJson(`${protocol_folder}fixtures/valid/${name}`)),
      ajv.errorsText(),
    ).toBe(true);
  });
});

describe('invalid fixtures', () => {
  const fixtures = filesOf(`${protocol_folder}fixtures/invalid`).map(
    (name) =>
      [name, readJson(`${protocol_folder}fixtures/invalid/${name}`) as InvalidFixture] as const,
  );
  const semantic = fixtures.filter(([, fixture]) => fixture.semantic);
  const documents = fixtures.filter(([, fixture]) => !fixture.semantic && 'document' in fixture);
  const texts = fixtures.filter(([, fixture]) => !fixture.semantic && fixture.text !== undefined);

  it('are each a document, a text, or for the server alone', () => {
    expect(semantic.length + documents.length + texts.length).toBe(fixtures.length);
  });

  it.each(documents)('%s is refused', (_name, { schema, document }) => {
    expect(validates(schema, document)).toBe(false);
  });

  it.each(texts)('%s is refused', (_name, { schema, text = '' }) => {
    expect(isRefusedText(text) || !validates(schema, JSON.parse(text))).toBe(true);
  });

  it.each(semantic)(
    '%s fits its schema, so that only the server can refuse it',
    (_name, { schema, document, text }) => {
      expect(validates(schema, document ?? JSON.parse(text ?? ''))).toBe(true);
    },
  );
});

describe('shipped styles', () => {
  it.each(filesOf(style_folder))('%s', (name) => {
    expect(validates('style', readJson(`${style_folder}${name}`))).toBe(true);
  });
});

describe('the channel description', () => {
  it('is a valid AsyncAPI document', { timeout: 60_000 }, async () => {
    const { diagnostics, document } = await fromFile(
      new Parser(),
      `${protocol_folder}asyncapi.yaml`,
    ).parse();
    const ERROR = 0;
    expect(diagnostics.filter((diagnostic) => (diagnostic.severity as number) === ERROR)).toEqual(
      [],
    );
    expect(document?.allMessages().length).toBeGreaterThan(0);
  });
});
