import { beforeEach, describe, expect, it } from 'vitest';
import { mergePatch, type JsonObject } from '../src/state/merge_patch.ts';
import { lookOf, ownStyle, retitled, withStyle } from '../src/state/own_styles.ts';
import { StyleFileError, styleFileText, styleFromFile } from '../src/state/style_file.ts';
import { capabilities, sceneMessage } from './capabilities.ts';
import { Harness } from './harness.ts';

const scene = sceneMessage.scene as JsonObject;

describe('a look', () => {
  it('is of a scene what is no volume, no place and no value of the volume', () => {
    expect(lookOf(scene)).toEqual({
      focus: {
        shading: { name: 'tone', detail: 0.5 },
        filters: [{ name: 'sobel', strength: 0.7 }],
      },
      context: { shading: { name: 'tone', detail: 0 }, filters: [] },
      lens: { mode: 'cutaway', cap: 'flat' },
    });
    const translucent = mergePatch(scene, { context: { surface: { opacity: 0.1 } } });
    expect(lookOf(translucent)).toMatchObject({ context: { surface: { opacity: 0.1 } } });
  });
});

describe('the list of own styles', () => {
  const [first, second] = [ownStyle('One', scene), ownStyle('Two', {})];

  it('replaces the one of the same title', () => {
    const other = ownStyle(' One ', {});
    expect(withStyle([first, second], other)).toEqual([other, second]);
  });

  it('gives a number to a title that another has, and keeps the old one for an empty one', () => {
    const titles = (wanted: string) =>
      retitled([first, second], 'Two', wanted).map(({ title }) => title);
    expect(titles('One')).toEqual(['One', 'One 2']);
    expect(titles('  ')).toEqual(['One', 'Two']);
    expect(titles('Two')).toEqual(['One', 'Two']);
    expect(titles('Three')).toEqual(['One', 'Three']);
  });
});

describe('a style’s file', () => {
  const refusal = (text: string): string => {
    try {
      styleFromFile(text, 'a.json');
    } catch (error) {
      if (error instanceof StyleFileError) return error.message;
    }
    return '';
  };

  it('is a scene document, and comes back as it was', () => {
    const style = ownStyle('My look', scene);
    expect(styleFromFile(styleFileText(style), 'My look.scene.json')).toEqual(style);
  });

  it('may be a whole scene, or a style of the server’s', () => {
    expect(styleFromFile(JSON.stringify(scene), 'x.json')).toEqual(ownStyle('x', scene));
    const served = { name: 'p', title: 'Plate', description: '', scene: { lens: { cap: 'open' } } };
    expect(styleFromFile(JSON.stringify(served), 'x.json')).toEqual(
      ownStyle('Plate', { lens: { cap: 'open' } }),
    );
  });

  it('is refused with the reason', () => {
    expect(refusal('{"version": 1,')).toMatch(/no JSON/);
    expect(refusal('[1]')).toMatch(/JSON object/);
    expect(refusal('{"version": 2, "focus": {}}')).toBe(
      'Its version is 2; this page reads version 1.',
    );
    expect(refusal('{"version": 1, "fokus": {}}')).toMatch(/“fokus”/);
    expect(refusal('{"version": 1, "camera": {}}')).toMatch(/nothing of a look/);
    expect(refusal('{"title": "x", "scene": {"version": 7}}')).toMatch(/version is 7/);
  });
});

describe('own styles in a session', () => {
  let harness: Harness;
  beforeEach(async () => {
    harness = new Harness();
    await harness.connect();
    harness.say(sceneMessage);
  });
  const styling = () => harness.session.own_styling;
  const titles = () => harness.state.own_styles.map(({ title }) => title);
  const file = (name: string, text: string) => ({
    name,
    size: text.length,
    text: () => Promise.resolve(text),
  });

  it('are kept, and there on the next visit', () => {
    styling().save('My look');
    const again = new Harness('', Object.fromEntries(harness.kept));
    again.session.own_styling.restore();
    expect(again.state.own_styles).toEqual([ownStyle('My look', scene)]);
  });

  it('are put on whole, whatever was changed', () => {
    styling().save('My look');
    const [style] = harness.state.own_styles;
    if (style) styling().apply(style);
    expect(harness.scenes().at(-1)?.scene).toMatchObject({
      focus: { shading: { name: 'tone', detail: 0.5, dark: null } },
      lens: { mode: 'cutaway' },
    });
    expect(harness.scenes().at(-1)?.scene).not.toHaveProperty('camera');
  });

  it('are what a group of the panel goes back to', () => {
    harness.session.commands.set(['focus', 'surface', 'opacity'], 0.25);
    styling().save('My look');
    harness.session.commands.set(['focus', 'surface', 'opacity'], 0.75);
    const [style] = harness.state.own_styles;
    if (style) styling().apply(style);
    harness.session.commands.resetGroup('focus');
    expect(harness.scenes().at(-1)?.scene).toMatchObject({
      focus: { surface: { iso_value: null, upper_value: null, opacity: 0.25 } },
    });
  });

  it('are recognised in a scene that is opened', () => {
    styling().save('My look');
    const again = new Harness('', Object.fromEntries(harness.kept));
    again.session.own_styling.restore();
    again.session.store.update({ capabilities: { ...capabilities, styles: [] } });
    again.say(sceneMessage);
    expect(again.state.base_style?.title).toBe('My look');
  });

  it('are what several pages have saved', () => {
    styling().save('Here');
    const stored = JSON.parse(harness.kept.get('cutaway.styles') ?? '') as { styles: unknown[] };
    stored.styles.push({ title: 'There', scene: { version: 1 } });
    harness.kept.set('cutaway.styles', JSON.stringify(stored));
    styling().save('Here too');
    expect(titles()).toEqual(['Here', 'There', 'Here too']);
  });

  it('are put aside where they cannot be read', () => {
    const old = new Harness('', { 'cutaway.styles': '{"version": 0}' });
    old.session.own_styling.restore();
    expect(old.state.toasts).toMatchObject([{ title: 'Your saved styles could not be read' }]);
    expect(old.state.own_styles).toEqual([]);
    expect(old.kept.get('cutaway.styles.unreadable')).toBe('{"version": 0}');
  });

  it('last as long as the page where the browser keeps nothing', () => {
    harness.kept.set = () => {
      throw new Error('full');
    };
    styling().save('One');
    styling().save('Two');
    expect(titles()).toEqual(['One', 'Two']);
    expect(harness.state.toasts).toHaveLength(1);
  });

  it('come from a file, and go again where the server refuses what is in it', async () => {
    await styling().importFile(file('bad.json', '{"focus": {"shading": {"name": "glow"}}}'));
    expect(titles()).toEqual(['bad']);
    harness.say({
      type: 'error',
      code: 'unknown-module',
      message: 'No such shading',
      field: '/focus/shading',
      input: harness.scenes().at(-1)?.input ?? 0,
    });
    expect(titles()).toEqual([]);
    expect(harness.state.toasts).toMatchObject([
      { title: 'bad could not be imported', detail: 'No such shading. Field: /focus/shading.' },
    ]);
  });

  it('leave a file that is too large or broken with its reason', async () => {
    await styling().importFile(file('large.json', ' '.repeat(70_000)));
    await styling().importFile(file('broken.json', '{'));
    expect(harness.state.toasts.map(({ title }) => title)).toEqual([
      'large.json could not be imported',
      'broken.json could not be imported',
    ]);
    expect(titles()).toEqual([]);
  });

  it('are saved as a file', async () => {
    styling().save('My look');
    const [style] = harness.state.own_styles;
    if (style) styling().exportFile(style);
    expect(harness.saved[0]?.[0]).toBe('My look.scene.json');
    expect(JSON.parse((await harness.saved[0]?.[1].text()) ?? '')).toEqual({
      version: 1,
      ...lookOf(scene),
    });
  });
});
