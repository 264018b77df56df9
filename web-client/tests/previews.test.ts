import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { SceneStateMessage } from '../src/protocol/messages.ts';
import type { JsonObject } from '../src/state/merge_patch.ts';
import { ownStyle, pictureKey } from '../src/state/own_styles.ts';
import { previewSize, previewSubject } from '../src/state/preview_subject.ts';
import { groupOf, stylesOf } from '../src/state/style_groups.ts';
import { swatchOf } from '../src/state/style_swatch.ts';
import { capabilities, sceneMessage } from './capabilities.ts';
import { frame, Harness, volumes } from './harness.ts';

const SIZE = { width_px: 160, height_px: 120 };
const REST_MS = 1_000;
const still = { ...frame(1, 1), still: true };

const bitmap = () => ({ width: 160, height: 120, close: vi.fn<() => void>() });

let harness: Harness;
beforeEach(async () => {
  harness = new Harness();
  await harness.connect();
  vi.useFakeTimers();
  harness.say(sceneMessage);
  harness.emit({ kind: 'shown', frame: still });
});
afterEach(() => void vi.useRealTimers());

const asked = () => harness.sent.filter((message) => message.type === 'preview');
const requests = () => asked().map(({ request }) => request);
const names = () => asked().map(({ style }) => style);
const want = (...styles: string[]): void => {
  harness.session.previews.resize(SIZE);
  const wishes = styles.map((style) => ({ key: style, preview: { style } }));
  harness.session.previews.want('served', wishes);
};
const rest = (): unknown => vi.advanceTimersByTime(REST_MS);
const answer = (request: number | undefined, picture = bitmap()) => {
  harness.emit({ kind: 'preview', request: request ?? -1, picture });
  return picture;
};

describe('pictures of the styles', () => {
  it('are asked for once the scene rests, in order, two at a time', () => {
    want('a', 'b', 'c');
    expect(names()).toEqual([]);
    rest();
    expect(names()).toEqual(['a', 'b']);
    expect(asked()[0]).toMatchObject(SIZE);
    const picture = answer(requests()[0]);
    expect(harness.state.previews.get('a')).toBe(picture);
    expect(names()).toEqual(['a', 'b', 'c']);
    answer(requests()[1]);
    answer(requests()[2]);
    rest();
    expect(asked()).toHaveLength(3);
  });

  it('are not asked for where the gallery is hidden', () => {
    want();
    rest();
    expect(asked()).toEqual([]);
  });

  it('wait while a pointer is held, while a volume loads, and for the refined picture', () => {
    want('a');
    harness.session.store.update({ pointer_held: true });
    rest();
    expect(asked()).toEqual([]);
    harness.emit({ kind: 'shown', frame: { ...still, still: false } });
    harness.session.store.update({ pointer_held: false });
    harness.say({ type: 'loading', volume: 'knee', stage: 'read', fraction: 0 });
    harness.emit({ kind: 'shown', frame: { ...still } });
    expect(asked()).toEqual([]);
    harness.say({ type: 'loading', volume: 'knee', stage: 'cancelled', fraction: 0 });
    expect(names()).toEqual(['a']);
  });

  it('are renewed after the camera has moved, and the old ones given back', () => {
    want('a');
    rest();
    const old = answer(requests()[0]);
    harness.session.commands.orbit(50, 0);
    vi.advanceTimersByTime(REST_MS / 2);
    harness.session.commands.orbit(50, 0);
    vi.advanceTimersByTime(REST_MS / 2);
    expect(asked()).toHaveLength(1);
    rest();
    expect(asked()).toHaveLength(2);
    expect(old.close).not.toHaveBeenCalled();
    const renewed = answer(requests()[1]);
    expect(old.close).toHaveBeenCalledOnce();
    expect(harness.state.previews.get('a')).toBe(renewed);
  });

  it('are not renewed for a change of look, which they do not show', () => {
    want('a');
    rest();
    answer(requests()[0]);
    harness.session.commands.set(['background', 'colour'], [1, 1, 1]);
    harness.session.commands.set(['focus', 'shading', 'detail'], 0);
    rest();
    expect(asked()).toHaveLength(1);
  });

  it('are dropped and asked for again where the scene changed on their way', () => {
    want('a');
    rest();
    harness.session.commands.orbit(50, 0);
    const late = answer(requests()[0]);
    expect(late.close).toHaveBeenCalledOnce();
    expect(harness.state.previews.has('a')).toBe(false);
    rest();
    expect(names()).toEqual(['a', 'a']);
  });

  it('of another volume are forgotten, also those on their way', () => {
    want('a', 'b');
    rest();
    const old = answer(requests()[0]);
    const knee: SceneStateMessage = {
      ...sceneMessage,
      volume: { ...sceneMessage.volume, id: 'knee' },
      scene: { ...sceneMessage.scene, volume: 'knee' },
    };
    harness.say(knee);
    expect(harness.state.previews.size).toBe(0);
    expect(old.close).toHaveBeenCalledOnce();
    const late = answer(requests()[1]);
    expect(late.close).toHaveBeenCalledOnce();
    expect(harness.state.previews.size).toBe(0);
    rest();
    expect(names()).toEqual(['a', 'b', 'a', 'b']);
  });

  it('that fail leave the drawing, without a message and without asking again', () => {
    want('a', 'b');
    rest();
    const [first = -1, second = -1] = requests();
    harness.say({ type: 'error', code: 'render-failed', message: 'Oh', request: first });
    harness.emit({ kind: 'preview', request: second });
    expect(harness.state.toasts).toEqual([]);
    expect(harness.state.previews.size).toBe(0);
    rest();
    expect(asked()).toHaveLength(2);
  });

  it('do not swallow the error of another request', () => {
    want('a');
    rest();
    harness.say({ type: 'error', code: 'render-failed', message: 'Oh', request: 999 });
    expect(harness.state.toasts).toHaveLength(1);
  });

  it('are asked for anew after a lost connection, once it shows a picture', () => {
    want('a');
    rest();
    harness.emit({
      kind: 'link',
      state: { phase: 'waiting', retry_in_ms: 1, reason: 'lost', said: '' },
    });
    harness.emit({ kind: 'link', state: { phase: 'connected' } });
    harness.say(capabilities);
    harness.say(volumes);
    harness.say(sceneMessage);
    expect(asked()).toHaveLength(1);
    harness.emit({ kind: 'shown', frame: { ...still } });
    expect(asked()).toHaveLength(2);
  });
});

describe('pictures of own styles', () => {
  const scene = { background: { colour: [1, 0, 0] } };

  it('are asked for by what the styles change, after the server’s', () => {
    want('a');
    harness.session.previews.want('own', [{ key: 'own x', preview: { scene } }]);
    rest();
    expect(asked()).toMatchObject([{ style: 'a' }, { scene, ...SIZE }]);
    expect(asked()[1]).not.toHaveProperty('style');
    const picture = answer(requests()[1]);
    expect(harness.state.previews.get('own x')).toBe(picture);
  });

  it('stay when a style is renamed, not when it is replaced', () => {
    const key = pictureKey(ownStyle('One', sceneMessage.scene as JsonObject));
    expect(pictureKey(ownStyle('Two', sceneMessage.scene as JsonObject))).toBe(key);
    expect(pictureKey(ownStyle('One', { background: { colour: [0, 0, 0] } }))).not.toBe(key);
  });
});

describe('pictures of volumes', () => {
  const wantVolumes = (...ids: string[]): void => harness.session.volume_pictures.want(ids, SIZE);
  const volumesAsked = () => asked().map(({ volume }) => volume);

  it('are asked for one at a time, once each', () => {
    wantVolumes('head', 'knee');
    expect(volumesAsked()).toEqual(['head']);
    expect(asked()[0]).toMatchObject(SIZE);
    const picture = answer(requests()[0]);
    expect(harness.state.volume_pictures.get('head')).toBe(picture);
    expect(volumesAsked()).toEqual(['head', 'knee']);
    answer(requests()[1]);
    wantVolumes('knee', 'head');
    expect(asked()).toHaveLength(2);
  });

  it('wait while the user waits for something', () => {
    harness.session.store.update({ pointer_held: true });
    wantVolumes('head');
    expect(asked()).toEqual([]);
    harness.session.store.update({ pointer_held: false });
    expect(asked()).toHaveLength(1);
  });

  it('that fail are not asked for again, without a message', () => {
    wantVolumes('head', 'knee');
    const [request = -1] = requests();
    harness.say({ type: 'error', code: 'volume-refused', message: 'Oh', request });
    expect(harness.state.volume_pictures.get('head')).toBe('failed');
    expect(harness.state.toasts).toEqual([]);
    expect(volumesAsked()).toEqual(['head', 'knee']);
  });

  it('are kept when another volume is opened, and asked for anew after a lost connection', () => {
    wantVolumes('head', 'knee');
    const picture = answer(requests()[0]);
    harness.emit({ kind: 'link', state: { phase: 'connecting' } });
    harness.emit({ kind: 'link', state: { phase: 'connected' } });
    harness.say(capabilities);
    expect(volumesAsked()).toEqual(['head', 'knee', 'knee']);
    const late = answer(requests()[1]);
    expect(late.close).toHaveBeenCalledOnce();
    expect(harness.state.volume_pictures.get('head')).toBe(picture);
  });
});

describe('what a preview shows', () => {
  const { scene } = sceneMessage;

  it('is camera, lens’ place and surfaces, not the look', () => {
    const subject = previewSubject(scene);
    expect(previewSubject({ ...scene, background: { colour: [1, 1, 1] } })).toBe(subject);
    expect(previewSubject({ ...scene, lens: { ...scene.lens, mode: 'magic' } })).toBe(subject);
    expect(previewSubject({ ...scene, lens: { ...scene.lens, radius_mm: 9 } })).not.toBe(subject);
    const context = { ...scene.context, surface: { iso_value: 7 } };
    expect(previewSubject({ ...scene, context })).not.toBe(subject);
  });

  it('has device pixels, as many as the protocol allows', () => {
    expect(previewSize({ width_px: 308, height_px: 231 })).toEqual({
      width_px: 308,
      height_px: 231,
    });
    expect(previewSize({ width_px: 1024, height_px: 768 })).toEqual({
      width_px: 512,
      height_px: 384,
    });
  });
});

describe('the gallery', () => {
  it('groups by what a style is for', () => {
    const [first, second] = capabilities.styles;
    const study = { ...first, name: 'study', group: 'study' } as typeof first & object;
    const styles = [...capabilities.styles, study];
    expect(stylesOf('illustration', styles)).toEqual([first, second]);
    expect(stylesOf('study', styles)).toEqual([study]);
    expect(groupOf(undefined)).toBe('illustration');
  });

  const swatch = (scene: object) =>
    swatchOf({ name: '', title: '', description: '', scene }, capabilities.modules);

  it('draws a style’s own colours, and the registry’s defaults', () => {
    const drawn = swatch({
      focus: { shading: { name: 'tone', detail: 0, light: [1, 1, 1] } },
      context: { shading: { name: 'phong', colour: [0, 1, 0] } },
      lens: { mode: 'magic', strength: 0.4 },
      background: { colour: [0, 0, 1] },
    });
    expect(drawn).toEqual({
      background: '#0000ff',
      focus: { dark: '#1a334d', light: '#ffffff', flat: true },
      context: { dark: '#005900', light: '#00ff00', flat: false },
      focus_share: 0.4,
    });
  });

  it('draws Gooch from cool to warm by its constants', () => {
    const shading = { name: 'gooch', colour: [1, 0, 0], blue: 1, yellow: 0.5, alpha: 0.2, beta: 0 };
    expect(swatch({ focus: { shading } }).focus).toEqual({
      dark: '#3300ff',
      light: '#808000',
      flat: false,
    });
  });
});
