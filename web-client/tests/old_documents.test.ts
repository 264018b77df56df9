// What people have kept of this page at an earlier version is read as it was: tests/golden/README.md.
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { OwnStyleStore } from '../src/session/own_style_store.ts';
import { mergePatch, omit, type JsonObject } from '../src/state/merge_patch.ts';
import { asStyle, type OwnStyle } from '../src/state/own_styles.ts';
import { sceneFromAddress } from '../src/state/scene_address.ts';
import { styleFromFile } from '../src/state/style_file.ts';
import { stylePatch } from '../src/state/style_patch.ts';
import { capabilities } from './capabilities.ts';

const folder = fileURLToPath(new URL('../../tests/golden/', import.meta.url));
const text = (path: string): string => readFileSync(`${folder}${path}`, 'utf8');
const document = (name: string): JsonObject =>
  JSON.parse(text(`documents/${name}.json`)) as JsonObject;
const namesIn = (place: string, ending: string): string[] =>
  readdirSync(`${folder}${place}`)
    .filter((name) => name.endsWith(ending))
    .map((name) => name.slice(0, -ending.length));

const links = namesIn('documents', '.link.txt');
const own_styles = namesIn('own_styles', '.scene.json');

describe('an old link', () => {
  it.each(links)('%s is the scene that it was', async (name) => {
    const scene = await sceneFromAddress(text(`documents/${name}.link.txt`).trim());
    expect(scene).toEqual(omit(document(name), ['viewport']));
  });

  it('is there', () => expect(links.length).toBeGreaterThan(0));
});

describe('an old own style', () => {
  const puts_on = (style: OwnStyle): JsonObject =>
    mergePatch(document('style-flagship-head'), stylePatch(asStyle(style), capabilities.modules));

  it.each(own_styles)('%s in a file makes the scene that it made', (name) => {
    const style = styleFromFile(text(`own_styles/${name}.scene.json`), `${name}.scene.json`);
    expect(puts_on(style)).toEqual(document(name));
  });

  it('that the browser kept is the one that the page exported', () => {
    const kept = text('own_styles/kept.json');
    const storage = { getItem: () => kept, setItem: () => undefined };
    const styles = new OwnStyleStore(() => storage).load() ?? [];
    expect(styles.map(({ title }) => title)).toEqual(['Teal through skin', 'Soft window']);
    expect(styles.map(puts_on)).toEqual(
      ['own-teal-through-skin', 'own-soft-window'].map((name) => document(name)),
    );
  });
});
