import { beforeEach, describe, expect, it, vi } from 'vitest';
import { applyKey } from '../src/interaction/keyboard.ts';
import type { ShownFrame } from '../src/stream/worker_messages.ts';
import { measurementsOf } from '../src/state/measure_state.ts';
import { windowControls } from '../src/state/slice_controls.ts';
import { isSettled, shownSlice } from '../src/state/slice_views.ts';
import type { ViewName } from '../src/state/views.ts';
import { sceneMessage, volume } from './capabilities.ts';
import { frame, Harness } from './harness.ts';

const place = { centre_mm: [0, 0, 0] as [number, number, number] };
const slices = {
  crosshair_mm: [0, 0, 0] as [number, number, number],
  superior: [0, 0, 1] as [number, number, number],
  anterior: [0, -1, 0] as [number, number, number],
  convention: 'radiological' as const,
  window: { centre: 40, width: 400 },
  axial: { ...place, view_height_mm: 100 },
  coronal: place,
  sagittal: place,
};
const told = { ...sceneMessage, scene: { ...sceneMessage.scene, slices } };
const SIZE = { width_px: 200, height_px: 100 };

let harness: Harness;
beforeEach(async () => {
  harness = new Harness();
  await harness.connect();
  harness.say(told);
  harness.session.layout.resize('axial', SIZE);
});

const slicing = () => harness.session.slicing;
const scene = () => harness.state.scene;
const lastPatch = () => {
  harness.nextFrame();
  return harness.scenes().at(-1)?.scene;
};
const sliceFrame = (input: number, still = true): ShownFrame => ({
  ...frame(input, 1),
  view: 1,
  still,
  viewport_width_px: 200,
  viewport_height_px: 100,
});

function press(key: string, view: ViewName, more: Partial<KeyboardEvent> = {}): boolean {
  const preventDefault = vi.fn();
  const held = { shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };
  const event = { key, ...held, ...more, preventDefault };
  applyKey(event as unknown as KeyboardEvent, harness.session, { view, device_pixels: 1 });
  return preventDefault.mock.calls.length > 0;
}

describe('a slice that is shown', () => {
  it('asks for its picture, and for none once it is gone', () => {
    expect(harness.sent).toContainEqual(
      expect.objectContaining({ type: 'viewport', view: 1, ...SIZE }),
    );
    harness.session.layout.close('axial');
    harness.session.layout.close('axial');
    expect(harness.sent.filter(({ type }) => type === 'close_view')).toEqual([
      { type: 'close_view', view: 1 },
    ]);
  });

  it('is asked for again after the connection was lost, with the volume', async () => {
    harness.sent.length = 0;
    await harness.connect();
    const views = harness.sent.flatMap((one) => (one.type === 'viewport' ? [one.view] : []));
    expect(views).toContain(0);
    expect(views).toContain(1);
  });

  it('is no input that the 3-D picture has to show', () => {
    const { sent_input } = harness.state;
    harness.session.layout.resize('axial', { width_px: 300, height_px: 100 });
    slicing().scroll('axial', 1);
    lastPatch();
    expect(harness.state.sent_input).toBe(sent_input);
    harness.session.commands.orbit(5, 0);
    lastPatch();
    expect(harness.state.sent_input).toBeGreaterThan(sent_input);
  });

  it('has drawn over it what its own frame shows', () => {
    harness.emit({ kind: 'shown', frame: sliceFrame(harness.state.sent_input) });
    expect(shownSlice(harness.state, 'axial')?.plane.centre_mm).toEqual([0, 0, 0]);
    expect(isSettled(harness.state, 'axial')).toBe(true);
    slicing().scroll('axial', 1);
    lastPatch();
    const input = harness.scenes().at(-1)?.input ?? 0;
    expect(isSettled(harness.state, 'axial')).toBe(false);
    expect(shownSlice(harness.state, 'axial')?.plane.centre_mm).toEqual([0, 0, 0]);
    harness.emit({ kind: 'shown', frame: sliceFrame(input) });
    expect(shownSlice(harness.state, 'axial')?.plane.centre_mm).toEqual([0, 0, 2]);
    expect(isSettled(harness.state, 'axial')).toBe(true);
  });

  it('leaves the volume’s frame and rate alone', () => {
    harness.emit({ kind: 'shown', frame: sliceFrame(1) });
    expect(harness.state.shown).toBeUndefined();
    expect(harness.state.frames_per_second).toBe(0);
  });
});

describe('the crosshair', () => {
  it('goes where the pointer is', () => {
    slicing().pointCrosshair('axial', [110, 30]);
    expect(lastPatch()).toEqual({ slices: { crosshair_mm: [10, -20, 0] } });
  });

  it('takes the lens along where that is wanted', () => {
    slicing().toggleLensAtCrosshair();
    expect(lastPatch()).toMatchObject({ lens: { centre_mm: [0, 0, 0] } });
    slicing().scroll('sagittal', 1);
    expect(lastPatch()).toEqual({
      slices: { crosshair_mm: [1, 0, 0] },
      lens: { centre_mm: [1, 0, 0] },
    });
  });

  it('goes to the surface under a press in 3-D', () => {
    slicing().pickCrosshair([4, 5]);
    const pick = harness.sent.findLast((message) => message.type === 'pick');
    expect(pick).toMatchObject({ view: 0, position_px: [4, 5] });
    harness.say({
      type: 'picked',
      request: pick?.request ?? 0,
      position_mm: [1, 2, 1],
      value: 3,
      units: 'HU',
      branch: 'context',
    });
    expect(lastPatch()).toEqual({ slices: { crosshair_mm: [1, 2, 1] } });
  });

  it('comes back in one step after a drag', () => {
    harness.session.store.update({ pointer_held: true });
    for (const x of [101, 105, 110]) {
      slicing().pointCrosshair('axial', [x, 50]);
      harness.nextFrame();
    }
    harness.session.store.update({ pointer_held: false });
    expect(scene()?.slices?.crosshair_mm).toEqual([10, 0, 0]);
    harness.session.commands.undo();
    expect(scene()?.slices?.crosshair_mm).toEqual([0, 0, 0]);
    harness.session.commands.redo();
    expect(scene()?.slices?.crosshair_mm).toEqual([10, 0, 0]);
  });

  it('may be moved for long where nothing answers: what is pending stays bounded', () => {
    for (let step = 0; step < 400; step++) {
      slicing().pointCrosshair('axial', [100 + (step % 7), 50]);
      harness.nextFrame();
    }
    harness.session.commands.setLensRadius(20);
    expect(lastPatch()).toEqual({ lens: { radius_mm: 20 } });
    expect(scene()?.slices?.crosshair_mm).toEqual([0, 0, 0]);
  });
});

describe('what the pointer is over', () => {
  const picks = () => harness.sent.filter((message) => message.type === 'pick');
  const found = () => harness.state.slice_hover?.found;
  function answer(value: number): void {
    const { request } = picks().at(-1) ?? { request: 0 };
    harness.say({ type: 'picked', request, position_mm: [1, 2, 0], value, units: 'HU' });
  }
  beforeEach(() => {
    slicing().readout.point('axial', [7, 8]);
    answer(55);
  });

  it('is asked for again when the slice’s picture becomes another', () => {
    expect(found()).toMatchObject({ value: 55 });
    harness.emit({ kind: 'shown', frame: sliceFrame(1, false) });
    expect(picks()).toHaveLength(2);
    expect(picks()[1]).toMatchObject({ view: 1, position_px: [7, 8] });
    answer(66);
    expect(found()).toMatchObject({ value: 66 });
    harness.emit({ kind: 'shown', frame: { ...sliceFrame(2), view: 2 } });
    expect(picks()).toHaveLength(2);
  });

  it('is not said of another volume, whose first picture has it asked for again', () => {
    harness.emit({ kind: 'shown', frame: sliceFrame(1) });
    harness.say({ ...told, revision: 2, volume: { ...volume, id: 'knee' } });
    expect(found()).toBeUndefined();
    answer(66);
    expect(found()).toBeUndefined();
    harness.emit({ kind: 'shown', frame: sliceFrame(2) });
    answer(77);
    expect(found()).toMatchObject({ value: 77 });
  });

  it('is not said once the connection is lost, or the slice is gone', () => {
    harness.emit({ kind: 'link', state: { phase: 'connecting' } });
    expect(found()).toBeUndefined();
    expect(harness.state.slice_hover).toBeDefined();
    harness.session.layout.close('axial');
    expect(harness.state.slice_hover).toBeUndefined();
  });

  it('is nothing after the pointer has left, whatever is shown then', () => {
    slicing().readout.pointAway();
    harness.emit({ kind: 'shown', frame: sliceFrame(1) });
    expect(harness.state.slice_hover).toBeUndefined();
    expect(picks()).toHaveLength(1);
  });
});

describe('the window', () => {
  it('has presets by key, in Hounsfield units alone', () => {
    expect(press('2', 'axial')).toBe(true);
    expect(lastPatch()).toEqual({ slices: { window: { centre: -600, width: 1500 } } });
    harness.say({ ...told, volume: { ...volume, units: 'none' } });
    harness.sent.length = 0;
    press('1', '3d');
    harness.nextFrame();
    expect(harness.scenes()).toEqual([]);
    expect(harness.state.toasts).toMatchObject([{ title: 'Window presets need Hounsfield units' }]);
  });

  it('may be typed beyond the volume’s values, which its sliders keep to', () => {
    const scene = { slices: { window: { centre: -600, width: 1500 } } };
    const soft: typeof volume = { ...volume, value_range: [-200, 800] };
    expect(windowControls(scene, soft)).toMatchObject([
      { value: -600, minimum: -200, maximum: 800, accepts: { minimum: -3.4e38, maximum: 3.4e38 } },
      { value: 1500, maximum: 1000, accepts: { minimum: 1e-30, maximum: 3.4e38 } },
    ]);
  });

  it('gets wider to the right and darker downwards', () => {
    slicing().dragWindow(64, 32);
    const { centre, width } = scene()?.slices?.window ?? {};
    expect(width).toBe(500);
    expect(centre).toBe(90);
    slicing().dragWindow(-1e6, 0);
    expect(scene()?.slices?.window?.width).toBeGreaterThan(0);
  });
});

describe('keys in a slice', () => {
  it('step, and mean something else than in 3-D', () => {
    press('ArrowUp', 'axial');
    expect(lastPatch()).toEqual({ slices: { crosshair_mm: [0, 0, 2] } });
    press('ArrowUp', '3d');
    expect(Object.keys(lastPatch() ?? {})).toEqual(['camera']);
  });

  it('move the crosshair, pan, tilt, and straighten', () => {
    press('ArrowRight', 'axial', { shiftKey: true });
    expect(lastPatch()).toEqual({ slices: { crosshair_mm: [4, 0, 0] } });
    press('ArrowRight', 'axial', { altKey: true });
    expect(lastPatch()).toMatchObject({ slices: { axial: { centre_mm: [-24, 0, 0] } } });
    press(',', 'axial');
    expect(Object.keys((lastPatch() as { slices: object }).slices)).toEqual([
      'superior',
      'anterior',
    ]);
    press('t', 'axial');
    expect(lastPatch()).toEqual({ slices: { superior: null, anterior: null } });
  });
});

describe('the lens in a slice', () => {
  it('moves in the plane and keeps its distance from it', () => {
    slicing().moveLensTo('axial', [110, 50]);
    expect(lastPatch()).toEqual({ lens: { centre_mm: [10, 0, 0] } });
  });

  it('gets the radius that its cut asks for', () => {
    harness.session.commands.set(['lens', 'centre_mm'], [0, 0, 3]);
    slicing().setLensCut('axial', [104, 50]);
    const { lens } = lastPatch() as { lens: { radius_mm: number } };
    expect(lens.radius_mm).toBeCloseTo(5, 1);
  });
});

describe('the layout', () => {
  it('is remembered, goes round by key, and a view is enlarged and comes back', () => {
    press('g', '3d');
    expect(harness.state.preferences.layout).toBe('grid');
    press('z', 'coronal');
    expect(harness.state.maximised).toBe('coronal');
    press('z', 'coronal');
    expect(harness.state.maximised).toBeUndefined();
    press('g', '3d');
    press('z', 'coronal');
    expect(harness.state.preferences).toMatchObject({ layout: 'focus', main_view: 'coronal' });
    press('g', '3d');
    expect(harness.state.preferences).toMatchObject({ layout: 'single', main_view: '3d' });
  });

  it('keeps the convention, in which the next scene begins', async () => {
    slicing().setConvention('neurological');
    expect(lastPatch()).toEqual({ slices: { convention: 'neurological' } });
    const { preferences } = harness.state;
    harness = new Harness();
    harness.session.store.update({ preferences });
    await harness.connect();
    expect(harness.scenes().at(-1)?.scene).toMatchObject({
      slices: { convention: 'neurological' },
    });
  });
});

describe('measuring in a slice', () => {
  it('asks for what lies there, which is no surface', () => {
    const { measuring } = harness.session;
    measuring.take('probe');
    measuring.place('axial', [7, 8]);
    const pick = harness.sent.findLast((message) => message.type === 'pick');
    expect(pick).toMatchObject({ view: 1, position_px: [7, 8] });
    harness.say({
      type: 'picked',
      request: pick?.request ?? 0,
      position_mm: [1, 2, 0],
      value: 55,
      units: 'HU',
    });
    expect(measurementsOf(harness.state.measure, volume)).toMatchObject([
      { kind: 'probe', points: [{ position_mm: [1, 2, 0], value: 55 }] },
    ]);
  });

  it('says that a point lies beside the volume', () => {
    const { measuring } = harness.session;
    measuring.take('probe');
    measuring.place('axial', [7, 8]);
    const pick = harness.sent.findLast((message) => message.type === 'pick');
    harness.say({ type: 'picked', request: pick?.request ?? 0 });
    expect(harness.state.toasts).toMatchObject([{ title: 'Beside the volume' }]);
  });
});
