import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Scene } from '../src/protocol/messages.ts';
import type { Commands } from '../src/session/commands.ts';
import { mergePatch, type JsonObject } from '../src/state/merge_patch.ts';
import { scenePatch } from '../src/state/scene_diff.ts';
import { withLook } from '../src/state/look.ts';
import { capabilities, sceneMessage } from './capabilities.ts';
import { Harness } from './harness.ts';

const PAUSE_MS = 500;

describe('the patch from one scene to another', () => {
  it.each<[string, JsonObject, JsonObject, JsonObject]>([
    ['nothing', { a: { b: [1, 2] } }, { a: { b: [1, 2] } }, {}],
    ['a value', { a: 1, b: 2 }, { a: 3, b: 2 }, { a: 3 }],
    ['a nested value', { a: { b: 1, c: 2 } }, { a: { b: 1, c: 3 } }, { a: { c: 3 } }],
    ['a field that goes', { a: { b: 1, c: 2 } }, { a: { b: 1 } }, { a: { c: null } }],
    ['a list, whole', { a: [1, { b: 1 }] }, { a: [1, { b: 2 }] }, { a: [1, { b: 2 }] }],
    [
      'a module of another name, whole',
      { s: { name: 'tone', detail: 1 } },
      { s: { name: 'phong', ambient: 0.1 } },
      { s: { name: 'phong', ambient: 0.1 } },
    ],
  ])('%s', (_name, from, to, patch) => {
    expect(scenePatch(from, to)).toEqual(patch);
    expect(mergePatch(from, patch)).toEqual(to);
  });
});

describe('a look', () => {
  it('leaves volume, camera and the place of the lens as they are', () => {
    const { scene } = sceneMessage;
    const other: Scene = {
      volume: 'knee',
      focus: { shading: { name: 'phong' } },
      lens: { mode: 'magic', centre_mm: [1, 2, 3], radius_mm: 99 },
    };
    expect(withLook(scene, other)).toEqual({
      version: 1,
      volume: 'head',
      camera: scene.camera,
      focus: { shading: { name: 'phong' } },
      lens: {
        mode: 'magic',
        shape: { name: 'sphere' },
        centre_mm: [0, -80, 0],
        radius_mm: 30,
      },
    });
  });
});

describe('undo and redo', () => {
  let harness: Harness;
  let commands: Commands;
  const scene = () => harness.state.scene as Scene;

  const hold = (pointer_held: boolean) => harness.session.store.update({ pointer_held });
  const style = (index: number) => {
    const wanted = capabilities.styles[index];
    if (wanted) commands.applyStyle(wanted);
  };

  beforeEach(async () => {
    harness = new Harness();
    ({ commands } = harness.session);
    await harness.connect();
    harness.say(sceneMessage);
    harness.sent.length = 0;
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  });
  afterEach(() => vi.useRealTimers());

  it('have nothing to do at first', () => {
    const before = scene();
    commands.undo();
    commands.redo();
    expect(scene()).toBe(before);
    expect(harness.state).toMatchObject({ can_undo: false, can_redo: false });
  });

  it('take a drag as one step, however long it rests in between', () => {
    const before = scene();
    hold(true);
    commands.orbit(10, 0);
    vi.advanceTimersByTime(3 * PAUSE_MS);
    commands.orbit(10, 5);
    hold(false);
    const after = scene();
    commands.undo();
    expect(scene()).toEqual(before);
    expect(harness.state).toMatchObject({ can_undo: false, can_redo: true });
    commands.redo();
    expect(scene()).toEqual(after);
  });

  it('take two drags as two steps, however quick', () => {
    hold(true);
    commands.orbit(10, 0);
    hold(false);
    const between = scene();
    hold(true);
    commands.orbit(10, 0);
    hold(false);
    commands.undo();
    expect(scene()).toEqual(between);
  });

  it('take turns of the wheel and held keys as one step until a pause', () => {
    const before = scene();
    commands.zoom(1.1);
    commands.zoom(1.1);
    const between = scene();
    vi.advanceTimersByTime(PAUSE_MS);
    commands.zoom(1.1);
    commands.undo();
    expect(scene()).toEqual(between);
    commands.undo();
    expect(scene()).toEqual(before);
  });

  it('send what differs, as one partial scene', () => {
    commands.setLensRadius(40);
    harness.nextFrame();
    harness.sent.length = 0;
    commands.undo();
    expect(harness.scenes()).toMatchObject([{ scene: { lens: { radius_mm: 30 } } }]);
    expect(harness.scenes()[0]?.scene).toEqual({ lens: { radius_mm: 30 } });
  });

  it('take back an upper end of a band, and a shading, whole', () => {
    commands.change({ focus: { surface: { upper_value: 900 } } });
    vi.advanceTimersByTime(PAUSE_MS);
    commands.change({ focus: { shading: { name: 'phong' } } });
    commands.undo();
    expect(scene().focus?.shading).toEqual({ name: 'tone', detail: 0.5 });
    commands.undo();
    expect(scene().focus?.surface).toEqual({ iso_value: 300 });
  });

  it('put the lens back to where a drag took it from', () => {
    hold(true);
    commands.dragLens([100, 100]);
    harness.nextFrame();
    harness.say({
      type: 'scene',
      revision: 2,
      input: 0,
      scene: { ...sceneMessage.scene, lens: { ...sceneMessage.scene.lens, centre_mm: [9, 9, 9] } },
    });
    hold(false);
    commands.undo();
    expect(scene().lens?.centre_mm).toEqual([0, -80, 0]);
    commands.redo();
    expect(scene().lens?.centre_mm).toEqual([9, 9, 9]);
  });

  it('go back to another volume with its whole scene', () => {
    const before = scene();
    const knee: Scene = { ...before, volume: 'knee', lens: { mode: 'none' } };
    commands.openVolume('knee');
    harness.say({ ...sceneMessage, scene: knee, volume: { ...sceneMessage.volume, id: 'knee' } });
    harness.sent.length = 0;
    commands.undo();
    expect(harness.scenes()).toMatchObject([{ replace: true, scene: before }]);
    harness.say(sceneMessage);
    commands.redo();
    expect(harness.scenes().at(-1)).toMatchObject({ replace: true, scene: knee });
  });

  it('forget what could be done again once something else is done', () => {
    commands.setLensRadius(40);
    commands.undo();
    commands.setLensRadius(50);
    expect(harness.state).toMatchObject({ can_undo: true, can_redo: false });
    commands.redo();
    expect(scene().lens?.radius_mm).toBe(50);
  });

  it('skip a step that changed nothing', () => {
    const before = scene();
    commands.setLensRadius(40);
    vi.advanceTimersByTime(PAUSE_MS);
    commands.setLensRadius(40);
    commands.undo();
    expect(scene()).toEqual(before);
  });

  it('keep a hundred steps', () => {
    for (let step = 0; step < 130; step++) {
      commands.setLensRadius(31 + (step % 50));
      vi.advanceTimersByTime(PAUSE_MS);
    }
    let steps = 0;
    for (; harness.state.can_undo; steps++) commands.undo();
    expect(steps).toBe(100);
  });

  it('put a group of the panel back to the style that was put on', () => {
    style(1);
    vi.advanceTimersByTime(PAUSE_MS);
    commands.change({ focus: { shading: { name: 'tone', detail: 0.9 } } });
    harness.nextFrame();
    harness.sent.length = 0;
    commands.resetGroup('focus');
    expect(harness.scenes()).toMatchObject([
      {
        scene: {
          focus: {
            surface: { iso_value: null, upper_value: null, opacity: null },
            filters: null,
            shading: { name: 'phong' },
          },
        },
      },
    ]);
    commands.undo();
    expect(scene().focus?.shading).toMatchObject({ name: 'tone', detail: 0.9 });
  });

  describe('comparing', () => {
    it('shows the previous look while held, in the present view', () => {
      const first = scene().focus?.shading;
      style(1);
      const second = scene().focus?.shading;
      commands.compare(true);
      expect(scene().focus?.shading).toEqual(first);
      expect(harness.state.comparing).toBe(true);
      commands.orbit(10, 0);
      const { camera } = scene();
      commands.compare(false);
      expect(scene().focus?.shading).toEqual(second);
      expect(scene().camera).toEqual(camera);
      commands.undo();
      expect(scene().focus?.shading).toEqual(second);
    });

    it('passes by steps that did not change the look', () => {
      const first = scene().focus?.shading;
      style(1);
      commands.orbit(10, 0);
      vi.advanceTimersByTime(PAUSE_MS);
      commands.setLensRadius(7);
      commands.compare(true);
      expect(scene().focus?.shading).toEqual(first);
      expect(scene().lens?.radius_mm).toBe(7);
    });

    it('says that there is none yet', () => {
      const before = scene();
      commands.compare(true);
      commands.compare(false);
      expect(scene()).toBe(before);
      expect(harness.state.toasts).toMatchObject([
        { title: 'There is no previous style to compare with yet' },
      ]);
    });
  });
});
