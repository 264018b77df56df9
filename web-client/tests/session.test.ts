import { beforeEach, describe, expect, it, vi } from 'vitest';
import type { SceneMessage } from '../src/protocol/messages.ts';
import { sceneToAddress } from '../src/state/scene_address.ts';
import { capabilities, sceneMessage } from './capabilities.ts';
import { frame, Harness, volumes } from './harness.ts';

let harness: Harness;
beforeEach(async () => {
  harness = new Harness();
  await harness.connect();
});

describe('the beginning', () => {
  it('opens the first volume and leaves its look to the server', () => {
    const [opened] = harness.scenes();
    expect(opened).toMatchObject({ replace: true, scene: { volume: 'head' } });
    expect(Object.keys(opened?.scene ?? {}).sort()).toEqual(['slices', 'volume']);
  });

  it('opens what the address says', async () => {
    const linked = new Harness(await sceneToAddress({ volume: 'knee', lens: { radius_mm: 5 } }));
    await linked.connect();
    expect(linked.scenes()).toMatchObject([
      { replace: true, scene: { volume: 'knee', lens: { radius_mm: 5 } } },
    ]);
  });

  it('says that an address is damaged, and opens the first volume', async () => {
    const broken = new Harness('#1.zzzz');
    await broken.connect();
    expect(broken.state.toasts).toMatchObject([{ title: 'This link could not be opened' }]);
    expect(broken.scenes()).toMatchObject([{ scene: { volume: 'head' } }]);
  });

  it('opens the first volume where the server refuses the address', async () => {
    const refused = new Harness(await sceneToAddress({ volume: 'gone' }));
    await refused.connect();
    refused.say({
      type: 'error',
      code: 'unknown-volume',
      message: 'No such volume',
      input: refused.scenes()[0]?.input ?? 0,
    });
    expect(refused.scenes().map(({ scene }) => scene['volume'])).toEqual(['gone', 'head']);
    expect(refused.state.toasts).toMatchObject([
      { title: 'This link could not be opened', detail: 'No such volume.' },
    ]);
  });
});

describe('a server that still looks for volumes', () => {
  const file = { id: 'chest', title: 'Chest', format: 'DICOM', modality: 'CT' };
  const opened = () => harness.scenes().map(({ scene }) => scene['volume']);

  beforeEach(() => {
    harness = new Harness();
    harness.emit({ kind: 'link', state: { phase: 'connected' } });
    harness.say(capabilities);
    harness.say({ ...volumes, scanning: true });
  });
  const awaited = () =>
    vi.waitFor(() => {
      expect(harness.state.awaits_volume).toBe(true);
    });

  it('has no phantom opened before the scan has ended', async () => {
    await awaited();
    expect(opened()).toEqual([]);
    harness.say({ ...volumes, scanning: false });
    expect(opened()).toEqual(['head']);
    expect(harness.state.awaits_volume).toBe(false);
  });

  it('has the first volume of a file opened as soon as that is there, once', async () => {
    await awaited();
    const found = { ...volumes, volumes: [file, ...volumes.volumes] };
    harness.say({ ...found, scanning: true });
    harness.say({ ...found, scanning: false });
    expect(opened()).toEqual(['chest']);
  });

  it('has nothing else opened than what the user has chosen meanwhile', async () => {
    await awaited();
    harness.session.commands.openVolume('knee');
    harness.say({ ...volumes, scanning: false });
    expect(opened()).toEqual(['knee']);
  });

  it('gets what the address says at once', async () => {
    harness = new Harness(await sceneToAddress({ volume: 'not found yet' }));
    harness.emit({ kind: 'link', state: { phase: 'connected' } });
    harness.say(capabilities);
    harness.say({ ...volumes, scanning: true });
    await vi.waitFor(() => expect(opened()).toEqual(['not found yet']));
  });
});

describe('input', () => {
  beforeEach(() => {
    harness.say(sceneMessage);
    harness.sent.length = 0;
  });

  it('goes out once per animation frame, with the sum of all moves', () => {
    harness.session.commands.orbit(10, 0);
    harness.session.commands.orbit(10, 0);
    harness.session.commands.zoom(1.1);
    expect(harness.sent).toEqual([]);
    harness.nextFrame();
    expect(harness.scenes()).toHaveLength(1);
    expect(harness.scenes()[0]?.scene['camera']).toEqual(harness.state.scene?.camera);
    harness.nextFrame();
    expect(harness.sent).toHaveLength(1);
  });

  it('counts up and carries the clock', () => {
    harness.session.commands.setLensRadius(20);
    harness.nextFrame();
    harness.session.commands.dragLens([10, 20]);
    harness.session.commands.dragLens([30, 40]);
    harness.nextFrame();
    const [radius, drag] = harness.sent as [SceneMessage, { input: number; clock_ms: number }];
    expect(drag).toMatchObject({
      type: 'drag_lens',
      position_px: [30, 40],
      input: radius.input + 1,
    });
    expect(drag.clock_ms).toBeGreaterThan(0);
  });

  it('keeps the order of a change and a reset', () => {
    harness.session.commands.setLensRadius(20);
    harness.session.commands.resetView();
    expect(harness.scenes().map(({ scene }) => scene)).toEqual([
      { lens: { radius_mm: 20 } },
      { camera: null, lens: { centre_mm: null, radius_mm: null } },
    ]);
  });

  it('bounds the lens by the volume', () => {
    harness.session.commands.setLensRadius(1e9);
    expect(harness.state.scene?.lens?.radius_mm).toBe(90);
  });

  it('goes back to the last good value with a message that names the field', () => {
    harness.session.commands.set(['lens', 'radius_mm'], -4);
    harness.nextFrame();
    const input = harness.scenes()[0]?.input ?? 0;
    harness.say({
      type: 'error',
      code: 'out-of-range',
      message: 'Too small',
      field: '/lens/radius_mm',
      expected: '0 to 2000 mm',
      received: '-4',
      input,
    });
    expect(harness.state.scene?.lens?.radius_mm).toBe(30);
    expect(harness.state.toasts[0]?.detail).toBe(
      'Too small. Field: /lens/radius_mm. Expected: 0 to 2000 mm. Received: -4.',
    );
  });

  it('shows the same message once', () => {
    for (let times = 0; times < 5; times++)
      harness.say({ type: 'error', code: 'internal', message: 'Oh' });
    expect(harness.state.toasts).toHaveLength(1);
  });
});

describe('a window larger than the server’s pictures', () => {
  it('gets a smaller picture of its shape, and says so once', () => {
    const { limits } = capabilities;
    harness.say({ ...capabilities, limits: { ...limits, viewport_pixels: 4_096_000 } });
    const { viewport_fit } = harness.session;
    const place = { width_px: 3840, height_px: 2160 };
    expect(viewport_fit.within(place)).toEqual({ width_px: 2698, height_px: 1517 });
    expect(viewport_fit.within({ width_px: 4000, height_px: 2000 }).width_px).toBeLessThan(4000);
    expect(harness.state.toasts).toMatchObject([
      { title: 'The picture is drawn smaller than this window and enlarged' },
    ]);
  });

  it('is no matter where its place has room', () => {
    const place = { width_px: 2560, height_px: 1440 };
    expect(harness.session.viewport_fit.within(place)).toBe(place);
    expect(harness.state.toasts).toEqual([]);
  });
});

describe('the picture', () => {
  it('knows which camera it shows', () => {
    harness.say(sceneMessage);
    harness.emit({ kind: 'shown', frame: frame(1, 1) });
    const before = harness.state.shown_scene?.camera;
    harness.session.commands.orbit(100, 0);
    harness.nextFrame();
    const input = harness.scenes().at(-1)?.input ?? 0;
    harness.emit({ kind: 'shown', frame: frame(input - 1, 1) });
    expect(harness.state.shown_scene?.camera).toEqual(before);
    harness.emit({ kind: 'shown', frame: frame(input, 2) });
    expect(harness.state.shown_scene?.camera).toEqual(harness.state.scene?.camera);
    expect(harness.state.scene?.camera).not.toEqual(before);
  });
});

describe('a lost connection', () => {
  it('is followed by viewport and whole scene, as they were', async () => {
    harness.say(sceneMessage);
    harness.session.commands.orbit(50, 20);
    harness.nextFrame();
    const scene = harness.state.scene;
    harness.emit({
      kind: 'link',
      state: { phase: 'waiting', retry_in_ms: 100, reason: 'lost', said: '' },
    });
    expect(harness.state.scene).toEqual(scene);
    harness.sent.length = 0;
    harness.emit({ kind: 'link', state: { phase: 'connected' } });
    harness.say({ type: 'queued', place: 2 });
    expect(harness.state.link).toEqual({ phase: 'queued', place: 2 });
    expect(harness.sent).toEqual([]);
    harness.say(capabilities);
    expect(harness.state.link).toEqual({ phase: 'connected' });
    expect(harness.sent).toMatchObject([
      { type: 'presence', visible: true },
      { type: 'viewport', width_px: 800, height_px: 600 },
    ]);
    harness.say(volumes);
    await vi.waitFor(() => expect(harness.scenes()).toHaveLength(1));
    expect(harness.scenes()[0]).toMatchObject({ replace: true, scene });
  });
});

describe('opening a volume', () => {
  it('keeps what is known of the volume while messages say no more of it', () => {
    harness.say(sceneMessage);
    const { volume: _, ...later } = sceneMessage;
    harness.say({ ...later, revision: 2 });
    expect(harness.state.volume).toEqual(sceneMessage.volume);
  });

  it('takes nothing from the old volume along, not even what was on its way', () => {
    harness.say(sceneMessage);
    harness.session.commands.orbit(100, 0);
    harness.session.commands.openVolume('knee');
    const opened = {
      ...sceneMessage,
      revision: 9,
      scene: { ...sceneMessage.scene, volume: 'knee' },
    };
    harness.say(opened);
    expect(harness.state.scene).toEqual(opened.scene);
    harness.emit({ kind: 'shown', frame: frame(1000, 9) });
    expect(harness.state.scene).toEqual(opened.scene);
  });

  it('shows progress and keeps the old scene until the new one is there', () => {
    harness.say(sceneMessage);
    harness.session.commands.openVolume('knee');
    expect(harness.sent.at(-1)).toMatchObject({ type: 'scene', scene: { volume: 'knee' } });
    harness.say({ type: 'loading', volume: 'knee', stage: 'decode', fraction: 0.5 });
    expect(harness.state.loading).toMatchObject({ stage: 'decode' });
    expect(harness.state.scene?.volume).toBe('head');
    harness.session.commands.cancelLoad();
    expect(harness.sent.at(-1)).toEqual({ type: 'cancel_load' });
    harness.say({ type: 'loading', volume: 'knee', stage: 'cancelled', fraction: 0 });
    expect(harness.state.loading).toBeUndefined();
    expect(harness.state.scene?.volume).toBe('head');
  });
});

describe('the lens', () => {
  beforeEach(() => harness.say(sceneMessage));

  it('comes back in the mode it had', () => {
    harness.session.commands.set(['lens', 'mode'], 'magic');
    harness.session.commands.toggleLens();
    expect(harness.state.scene?.lens?.mode).toBe('none');
    harness.session.commands.toggleLens();
    expect(harness.state.scene?.lens?.mode).toBe('magic');
  });

  it('follows the pointer from a command on, and comes on for it', () => {
    harness.session.commands.set(['lens', 'mode'], 'none');
    harness.session.commands.followPointer();
    expect(harness.state).toMatchObject({
      lens_follows: true,
      scene: { lens: { mode: 'cutaway' } },
    });
    harness.session.commands.followPointer(false);
    expect(harness.state.lens_follows).toBe(false);
  });
});

describe('the lens by key', () => {
  const drags = () =>
    harness.sent.filter((message) => message.type === 'drag_lens').map((drag) => drag.position_px);
  const nudge = () => {
    harness.session.commands.nudgeLens(10, 0);
    harness.nextFrame();
  };

  beforeEach(() => {
    harness.say(sceneMessage);
    harness.emit({ kind: 'shown', frame: frame(harness.state.sent_input, 1) });
  });

  it('loses no step of keys that repeat faster than pictures come', () => {
    nudge();
    nudge();
    harness.emit({ kind: 'shown', frame: frame(harness.state.sent_input - 1, 1) });
    nudge();
    const [first = 0, second = 0, third = 0] = drags().map(([x]) => x);
    expect([second - first, third - second]).toEqual([10, 10]);
  });

  it('begins where the lens is seen once something else was done', () => {
    nudge();
    harness.session.commands.orbit(50, 0);
    harness.nextFrame();
    nudge();
    const [first = 0, second = 1] = drags().map(([x]) => x);
    expect(second).toBeCloseTo(first);
  });
});

describe('a value left to the server', () => {
  it('goes out at once, after what was waiting', () => {
    harness.say(sceneMessage);
    harness.sent.length = 0;
    harness.session.commands.setLensRadius(20);
    harness.session.commands.change({ focus: { surface: { upper_value: null } } });
    expect(harness.scenes().map(({ scene }) => scene)).toEqual([
      { lens: { radius_mm: 20 } },
      { focus: { surface: { upper_value: null } } },
    ]);
  });
});
