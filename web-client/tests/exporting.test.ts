import { beforeEach, describe, expect, it, vi } from 'vitest';
import { applyKey } from '../src/interaction/keyboard.ts';
import type { FilmWish } from '../src/session/exporting.ts';
import { timeLeftMs } from '../src/state/export_state.ts';
import { timeLeftText } from '../src/state/export_text.ts';
import { sceneMessage, volume } from './capabilities.ts';
import { Harness } from './harness.ts';

let harness: Harness;
beforeEach(async () => {
  harness = new Harness();
  await harness.connect();
  harness.say(sceneMessage);
});

const size = { width_px: 64, height_px: 48 };
const exporting = () => harness.session.exporting;
const state = () => harness.state.exporting;
const asked = () => harness.sent.filter((message) => message.type === 'save_still');
const lastRequest = () => asked().at(-1)?.request ?? 0;
const answer = (request: number): void =>
  harness.emit({ kind: 'saved_still', request, png: new Blob(['png']) });
/** Lets what waits for answers go on. */
const settle = () => new Promise((done) => setTimeout(done));

const wish: FilmWish = {
  motion: { axis: 'superior', degrees: 360, seconds: 1, direction: 'right' },
  frames_per_second: 4,
  size,
  format: { format: 'zip' },
};

describe('a picture', () => {
  it('is asked for in the size wanted, and saved under the volume’s name', async () => {
    const saving = exporting().savePicture('3d', { width_px: 3000, height_px: 2000 });
    expect(harness.sent.at(-1)).toEqual({
      type: 'save_still',
      request: lastRequest(),
      width_px: 3000,
      height_px: 2000,
    });
    expect(state().job).toMatchObject({ what: 'picture' });
    answer(lastRequest());
    await saving;
    expect(harness.saved[0]?.[0]).toBe('cutaway Head.png');
    expect(state()).toMatchObject({ job: undefined, outcome: { kind: 'saved', bytes: 3 } });
  });

  it('stays bare, with a word of it, where the browser cannot draw, and without one as wanted', async () => {
    const save = async (): Promise<void> => {
      const saving = exporting().savePicture('3d', size);
      answer(lastRequest());
      await saving;
    };
    const complaints = () => harness.state.toasts.filter(({ tone }) => tone === 'problem');
    await save();
    expect(complaints()).toMatchObject([{ title: 'Saved without labels' }]);
    harness.session.toasts.dismiss(complaints()[0]?.id ?? 0);
    harness.session.commands.prefer({ picture_labels: false });
    await save();
    expect(complaints()).toEqual([]);
    expect(harness.saved).toHaveLength(2);
  });

  it('of a slice is asked for by the slice’s number, and named after it', async () => {
    const saving = exporting().savePicture('coronal', size);
    expect(harness.sent.at(-1)).toMatchObject({ type: 'save_still', view: 2, ...size });
    answer(lastRequest());
    await saving;
    expect(harness.saved[0]?.[0]).toBe('cutaway Head coronal.png');
  });

  it('is of the view from which the export was opened, or of the large one', () => {
    exporting().open('axial');
    expect(state()).toMatchObject({ open: true, view: 'axial' });
    exporting().open();
    expect(state().view).toBe('3d');
    harness.session.commands.prefer({ layout: 'focus', main_view: 'sagittal' });
    exporting().open();
    expect(state().view).toBe('sagittal');
  });

  it('shows what the user has changed just now', () => {
    harness.session.commands.orbit(10, 0);
    void exporting().savePicture('3d', size);
    expect(harness.sent.slice(-2).map(({ type }) => type)).toEqual(['scene', 'save_still']);
  });

  it('that is refused says why, in the dialog or without it', async () => {
    const refusal = { type: 'error', code: 'too-large', message: 'No' } as const;
    exporting().show(true);
    const first = exporting().savePicture('3d', size);
    harness.say({ ...refusal, request: lastRequest() });
    await first;
    const outcome = { kind: 'failed', title: 'Too large for this server', detail: 'No.' };
    expect(state().outcome).toEqual(outcome);
    expect(harness.state.toasts).toEqual([]);
    exporting().show(false);
    expect(state().outcome).toBeUndefined();
    const second = exporting().savePicture('3d', size);
    harness.say({ ...refusal, request: lastRequest() });
    await second;
    expect(harness.state.toasts).toMatchObject([{ title: 'Too large for this server' }]);
  });

  it('is asked for again after a lost connection, of the scene as it was', async () => {
    const camera = harness.state.scene?.camera;
    const saving = exporting().savePicture('3d', size);
    harness.emit({ kind: 'link', state: { phase: 'connecting' } });
    expect(state()).toMatchObject({ lags: true, job: { what: 'picture' } });
    harness.session.commands.orbit(10, 0);
    await harness.connect();
    expect(asked()).toHaveLength(1);
    harness.say(sceneMessage);
    expect(asked()[1]).toMatchObject({ ...size, scene: { camera } });
    expect(state().lags).toBe(false);
    answer(lastRequest());
    await saving;
    expect(harness.saved).toHaveLength(1);
  });
});

describe('a film', () => {
  it('is asked for frame by frame, two at a time, and leaves the scene alone', async () => {
    const before = harness.state.scene;
    const saving = exporting().saveFilm(wish);
    // What writes the file is loaded first.
    await vi.waitFor(() => expect(asked()).toHaveLength(2));
    const cameras: unknown[] = [];
    for (let frame = 0; frame < 4; frame++) {
      const still = asked()[frame];
      cameras.push((still?.scene?.['camera'] as { eye_mm: unknown } | undefined)?.eye_mm);
      answer(still?.request ?? 0);
      await settle();
      expect(asked().length).toBe(Math.min(4, frame + 3));
    }
    await saving;
    expect(new Set(cameras.map((eye) => JSON.stringify(eye))).size).toBe(4);
    expect(harness.state.scene).toBe(before);
    expect(harness.saved[0]?.[0]).toBe('cutaway Head.zip');
  });

  it('goes on from the frame it was at after a lost connection', async () => {
    const saving = exporting().saveFilm(wish);
    await vi.waitFor(() => expect(asked()).toHaveLength(2));
    answer(asked()[0]?.request ?? 0);
    await settle();
    harness.emit({ kind: 'link', state: { phase: 'connecting' } });
    await harness.connect();
    harness.say(sceneMessage);
    const scenes = asked().map(({ scene }) => scene);
    expect(scenes.slice(3)).toEqual(scenes.slice(1, 3));
    for (const request of [4, 5, 6]) {
      answer(asked().find((one) => one.request === request)?.request ?? lastRequest());
      await settle();
    }
    await saving;
    expect(harness.saved).toHaveLength(1);
    expect(harness.state.toasts.filter(({ tone }) => tone === 'problem')).toMatchObject([
      { title: 'Saved without labels' },
    ]);
  });

  it('tells how far it is', async () => {
    void exporting().saveFilm(wish);
    await settle();
    answer(asked()[0]?.request ?? 0);
    await settle();
    expect(state().job).toMatchObject({ frames: 4, frames_done: 1 });
    const job = { what: 'film', frames: 4, frames_done: 1, began_ms: 1000 } as const;
    expect(timeLeftMs(job, 3000)).toBe(6000);
    expect(timeLeftText(job, 3000)).toBe('6 seconds left');
    expect(timeLeftText({ ...job, frames: 400 }, 3000)).toBe('about 13 minutes left');
    expect(timeLeftText({ ...job, frames_done: 0 }, 3000)).toBe('');
  });

  it('that is cancelled asks for nothing more, saves nothing and makes no complaint', async () => {
    const saving = exporting().saveFilm(wish);
    await settle();
    exporting().cancel();
    await saving;
    expect(state()).toMatchObject({ job: undefined, outcome: undefined });
    for (const { request } of asked()) answer(request);
    await settle();
    expect(asked()).toHaveLength(2);
    expect(harness.saved).toEqual([]);
    expect(harness.state.toasts).toEqual([]);
  });

  it('after one that was cancelled waits for what the server still makes', async () => {
    const first = exporting().saveFilm(wish);
    await settle();
    exporting().cancel();
    await first;
    void exporting().savePicture('3d', size);
    expect(asked()).toHaveLength(2);
    answer(asked()[0]?.request ?? 0);
    expect(asked()).toHaveLength(3);
    expect(asked()[2]).not.toHaveProperty('scene');
  });

  it('ends when another volume is opened', async () => {
    const saving = exporting().saveFilm(wish);
    await settle();
    harness.say({ ...sceneMessage, revision: 2, volume: { ...volume, id: 'knee' } });
    await saving;
    expect(state().outcome).toMatchObject({
      detail: expect.stringContaining('Another volume') as string,
    });
  });
});

describe('a recording', () => {
  const press = (key: string, shiftKey = false): void => {
    const event = { key, shiftKey, ctrlKey: false, metaKey: false, altKey: false };
    const handled = { ...event, preventDefault: () => undefined };
    applyKey(handled as unknown as KeyboardEvent, harness.session, {
      view: '3d',
      device_pixels: 1,
    });
  };

  it('keeps what the user does until it is ended, and opens the dialog', () => {
    vi.spyOn(performance, 'now').mockReturnValue(1000);
    exporting().show(true);
    exporting().recorder.start();
    expect(state()).toMatchObject({ open: false, recording_since_ms: 1000 });
    vi.spyOn(performance, 'now').mockReturnValue(1250);
    harness.session.commands.orbit(20, 0);
    vi.spyOn(performance, 'now').mockReturnValue(3000);
    press('e');
    expect(state()).toMatchObject({ open: true, recording_since_ms: undefined });
    expect(state().path?.duration_ms).toBe(2000);
    expect(state().path?.samples.map(({ at_ms }) => at_ms)).toEqual([0, 250]);
    vi.restoreAllMocks();
  });

  it('begins and ends by key', () => {
    press('E', true);
    expect(state().recording_since_ms).toBeDefined();
    press('E', true);
    expect(state()).toMatchObject({ recording_since_ms: undefined, open: true });
  });

  it('is of one volume', () => {
    exporting().recorder.start();
    harness.say({ ...sceneMessage, revision: 2, volume: { ...volume, id: 'knee' } });
    expect(state()).toMatchObject({ recording_since_ms: undefined, path: undefined, open: false });
  });

  it('becomes a film', async () => {
    exporting().recorder.start();
    harness.session.commands.orbit(20, 0);
    exporting().recorder.stop();
    const saving = exporting().saveFilm({ ...wish, motion: 'path' });
    await settle();
    expect(asked()[0]?.scene).toHaveProperty('camera');
    answer(lastRequest());
    await saving;
    expect(harness.saved).toHaveLength(1);
  });
});
