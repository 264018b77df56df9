import { readFileSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { SCENE_FIELDS, type ModuleDescription } from '../src/protocol/messages.ts';
import { keepSpeaking } from '../src/session/kept_speech.ts';
import { lensModeControls } from '../src/state/lens_controls.ts';
import { english } from '../src/words/english.ts';
import { german } from '../src/words/german.ts';
import { languageFor } from '../src/words/language.ts';
import { numberIn, pluralIn } from '../src/words/plural.ts';
import { capabilitiesInWords, volumeInWords } from '../src/words/served.ts';
import { speak, words } from '../src/words/words.ts';
import { capabilities } from './capabilities.ts';
import { Harness, volumes } from './harness.ts';

describe('the language', () => {
  it.each([
    ['de', ['en-GB'], 'de'],
    ['auto', ['de-AT', 'en'], 'de'],
    ['auto', ['fr-FR', 'DE'], 'de'],
    ['auto', ['fr', 'en-US', 'de'], 'en'],
    ['auto', ['fr'], 'en'],
    ['auto', [], 'en'],
  ] as const)('chosen %s, wanted %j: %s', (choice, wanted, language) => {
    expect(languageFor(choice, wanted)).toBe(language);
  });
});

describe('forms of a language', () => {
  it('counts', () => {
    const forms = { one: '# Bild', other: '# Bilder' };
    expect([0, 1, 2, 12_000].map((count) => pluralIn('de')(count, forms))).toEqual([
      '0 Bilder',
      '1 Bild',
      '2 Bilder',
      '12.000 Bilder',
    ]);
  });

  it('writes numbers', () => {
    expect(numberIn('de')(1234.56, 1)).toBe('1.234,6');
    expect(numberIn('en')(1234.56, 1)).toBe('1,234.6');
    expect(numberIn('en')(7)).toBe('7');
  });
});

/** Every text of a catalogue, by its path; functions are called with stand-ins. */
function texts(part: unknown, path = ''): [string, string][] {
  if (typeof part === 'string') return [[path, part]];
  if (typeof part !== 'object' || part === null) return [];
  return Object.entries(part).flatMap(([key, inner]) => texts(inner, `${path}/${key}`));
}

describe('the German catalogue', () => {
  it('has the keys of the English one, and no others', () => {
    const keys = (catalogue: object): string[] =>
      texts({ ...catalogue, served: {} }).map(([path]) => path);
    expect(keys(german).sort()).toEqual(keys(english).sort());
  });

  it('leaves nothing empty', () => {
    expect(texts(german).filter(([, text]) => text.trim() === '')).toEqual([]);
  });
});

interface Described {
  readonly title?: string;
  readonly enum?: readonly string[];
  readonly properties?: Readonly<Record<string, Described>>;
  readonly 'x-level'?: string;
}

/** Of a registry of the schema: modules by name. */
const registryOf = (name: string): [string, Described][] => {
  const file = new URL('../../protocol/schema/modules.schema.json', import.meta.url);
  const { definitions } = JSON.parse(readFileSync(file, 'utf8')) as {
    definitions: Record<string, Record<string, Described>>;
  };
  return Object.entries(definitions[name] ?? {}).map(([module, described]) => [
    `${name}.${module}`,
    described,
  ]);
};

describe('the German words for what a scene is built from', () => {
  const modules = ['shading', 'filter', 'lens_shape'].flatMap(registryOf);
  const parameters = modules.flatMap(([module, { properties = {} }]) =>
    Object.entries(properties)
      .filter(([, one]) => one['x-level'] !== undefined)
      .map(([name, one]): [string, Described] => [`${module}.${name}`, one]),
  );
  const { served } = german;

  it('are there for every module and every parameter that the panel shows', () => {
    expect(modules.length).toBeGreaterThan(15);
    expect(modules.map(([name]) => name).filter((name) => !served.modules[name])).toEqual([]);
    const missing = parameters.map(([name]) => name).filter((name) => !served.parameters[name]);
    expect(missing).toEqual([]);
  });

  it('name every choice, of the scene’s own fields too', () => {
    const { 'normals.scale': _shown_as_smoothing, ...fields } = SCENE_FIELDS;
    const own = Object.values(fields).flatMap((field) =>
      'choices' in field ? [...field.choices] : [],
    );
    const choices = [...parameters.flatMap(([, one]) => one.enum ?? []), ...own];
    expect(choices).toContain('section');
    const names_of_people = ['phong', 'blinn', 'l1', 'l2'];
    const known = [...Object.keys(served.choices), ...names_of_people];
    expect(choices.filter((choice) => !known.includes(choice))).toEqual([]);
  });
});

describe('names that the server sends', () => {
  const [tone] = capabilities.modules.shading as [ModuleDescription];

  it('are German where the catalogue has them', () => {
    const translated = capabilitiesInWords(capabilities, german.served);
    expect(translated.modules.shading[0]?.title).toBe('Tonwert');
    const detail = translated.modules.shading[0]?.parameters.find(({ name }) => name === 'detail');
    expect(detail).toMatchObject({ title: 'Detail', minimum: 0, maximum: 1 });
    expect(volumeInWords({ id: 'phantom:head', title: 'Head phantom' }, german.served).title).toBe(
      'Kopfphantom',
    );
  });

  it('stay the server’s where it has not', () => {
    const other = { ...tone, name: 'stipple', title: 'Stipple', description: 'Dots.' };
    const modules = { ...capabilities.modules, shading: [other] };
    const translated = capabilitiesInWords({ ...capabilities, modules }, german.served);
    expect(translated.modules.shading[0]).toMatchObject({ title: 'Stipple', description: 'Dots.' });
    const volume = { id: 'ct/thorax', title: 'Thorax' };
    expect(volumeInWords(volume, german.served)).toEqual(volume);
  });

  it('stay as they are in English', () => {
    expect(capabilitiesInWords(capabilities, english.served)).toEqual(capabilities);
  });
});

describe('a page', () => {
  const page = { lang: '' } as HTMLElement;
  let harness: Harness;

  beforeEach(async () => {
    harness = new Harness();
    await harness.connect();
  });

  afterEach(async () => {
    await speak('en');
  });

  it('speaks what the browser wants, and changes over without a reload', async () => {
    await keepSpeaking(harness.session, page, ['de-CH']);
    expect([page.lang, words().panel.tabs.styles]).toEqual(['de', 'Stile']);
    expect(harness.state.language).toBe('de');
    const [, cap] = lensModeControls({ lens: { mode: 'cutaway' } });
    expect(cap).toMatchObject({ label: 'Schnittflächen' });
    harness.session.commands.prefer({ language: 'en' });
    await vi.waitFor(() => expect(page.lang).toBe('en'));
    expect(words().panel.tabs.styles).toBe('Styles');
  });

  it('has what the server told before in the language too', async () => {
    harness.say({
      ...volumes,
      volumes: [{ id: 'phantom:head', title: 'Head', format: 'phantom', modality: 'CT' }],
    });
    await keepSpeaking(harness.session, page, ['de']);
    expect(harness.state.capabilities?.modules.shading[0]?.title).toBe('Tonwert');
    expect(harness.state.volumes[0]?.title).toBe('Kopfphantom');
    harness.session.commands.prefer({ language: 'en' });
    await vi.waitFor(() => expect(harness.state.volumes[0]?.title).toBe('Head'));
  });
});
