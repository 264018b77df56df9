import { describe, expect, it, vi } from 'vitest';
import { mixCameras, pathFilm, sceneAt, type CameraPath } from '../src/film/camera_path.ts';
import { chosenSize, filmPresets, picturePresets, withSide } from '../src/film/picture_size.ts';
import { pipelined } from '../src/film/pipeline.ts';
import { withNotes } from '../src/film/png_notes.ts';
import { turntableFilm, type Turntable } from '../src/film/turntable.ts';
import { zipFile } from '../src/film/zip_file.ts';
import type { Scene } from '../src/protocol/messages.ts';
import { mergePatch, type JsonObject } from '../src/state/merge_patch.ts';
import { cameraOf } from '../src/state/scene_parts.ts';
import type { Camera } from '../src/view/camera.ts';
import { length } from '../src/view/vector.ts';
import { sceneMessage } from './capabilities.ts';

const { scene } = sceneMessage;
const camera = cameraOf(scene) as Camera;
const view = { width_px: 1000, height_px: 800 };

const eyeOf = (patch: JsonObject) => (patch['camera'] as unknown as Camera).eye_mm;

const near = (wanted: readonly number[]) => wanted.map((part) => expect.closeTo(part, 3) as number);

describe('sizes of a picture', () => {
  it('keep the view’s shape and the server’s limit', () => {
    const presets = picturePresets(view, 4096);
    expect(presets.map(({ id, size }) => [id, size.width_px, size.height_px])).toEqual([
      ['view', 1000, 800],
      ['double', 2000, 1600],
      ['4k', 3840, 3072],
      ['a4', 3100, 2480],
    ]);
    expect(presets.at(-1)?.dots_per_inch).toBe(300);
  });

  it('turn a sheet of paper for an upright view', () => {
    const presets = picturePresets({ width_px: 390, height_px: 844 }, 8192);
    expect(presets.find(({ id }) => id === 'a4')?.size).toEqual({
      width_px: 1621,
      height_px: 3508,
    });
  });

  it('are even for a film', () => {
    for (const { size } of filmPresets({ width_px: 1001, height_px: 777 }, 8192))
      expect([size.width_px % 2, size.height_px % 2]).toEqual([0, 0]);
  });

  it('follow one side, or are both given', () => {
    expect(withSide(view, 'width_px', 3000, view, 8192)).toEqual({
      width_px: 3000,
      height_px: 2400,
    });
    expect(withSide(view, 'width_px', 3000, undefined, 8192)).toEqual({
      width_px: 3000,
      height_px: 800,
    });
    expect(withSide(view, 'height_px', 8192, view, 8192)).toEqual({
      width_px: 8192,
      height_px: 6554,
    });
    expect(withSide(view, 'width_px', 99_999, undefined, 8192).width_px).toBe(8192);
  });

  it('are the first one’s where the chosen one is gone', () => {
    const presets = picturePresets(view, 1500);
    const wish = { preset: '8k', own: view, keeps_shape: true } as const;
    expect(chosenSize(wish, presets).size).toEqual(view);
  });
});

describe('a turntable', () => {
  const wish: Turntable = { axis: 'superior', degrees: 360, seconds: 1, direction: 'right' };

  it('goes around once, and ends a step before it began', () => {
    const film = turntableFilm(scene, camera, wish, 4);
    expect(film.frames).toBe(4);
    const eyes = [0, 1, 2, 3].map((index) => eyeOf(film.sceneOf(index)));
    expect(eyes).toEqual(
      [
        [0, -600, 0],
        [-600, 0, 0],
        [0, 600, 0],
        [600, 0, 0],
      ].map(near),
    );
  });

  it('ends where it shall, and turns the other way', () => {
    const film = turntableFilm(scene, camera, { ...wish, degrees: 90, direction: 'left' }, 10);
    expect(eyeOf(film.sceneOf(9))).toEqual(near([600, 0, 0]));
  });

  it('turns about the picture’s upright', () => {
    const tilted: Camera = { ...camera, up: [1, 0, 0] };
    const film = turntableFilm(scene, tilted, { ...wish, axis: 'view_up' }, 4);
    expect(eyeOf(film.sceneOf(2))).toEqual(near([0, 600, 0]));
    expect(eyeOf(film.sceneOf(1))[2]).not.toBeCloseTo(0);
  });

  it('says the whole scene, whatever becomes of the session’s', () => {
    const patch = turntableFilm(scene, camera, wish, 4).sceneOf(0);
    const changed = mergePatch(scene as JsonObject, {
      focus: { surface: { iso_value: 1, upper_value: 900 }, shading: { name: 'phong' } },
      lens: { radius_mm: 1 },
    });
    const made = mergePatch(changed, patch) as Scene;
    expect(made.focus).toMatchObject(scene.focus as object);
    expect(made.lens).toEqual(scene.lens);
    expect(patch).not.toHaveProperty('volume');
  });
});

describe('a recorded path', () => {
  const at = (eye_mm: readonly [number, number, number], radius_mm: number): Scene => ({
    ...scene,
    camera: { ...scene.camera, eye_mm: [...eye_mm] },
    lens: { ...scene.lens, radius_mm },
  });
  const path: CameraPath = {
    duration_ms: 2_100,
    samples: [
      { at_ms: 0, scene: at([0, -600, 0], 10) },
      { at_ms: 100, scene: at([-600, 0, 0], 20) },
      { at_ms: 2_000, scene: at([0, 600, 0], 30) },
    ],
  };
  const eyeAt = (at_ms: number) => sceneAt(path, at_ms)?.camera?.eye_mm;

  it('glides within a motion, at the same distance', () => {
    const eye_mm = eyeAt(50) ?? [0, 0, 0];
    expect(length(eye_mm)).toBeCloseTo(600);
    expect(eye_mm[0]).toBeCloseTo(eye_mm[1]);
    expect(sceneAt(path, 50)?.lens?.radius_mm).toBeCloseTo(15);
  });

  it('rests between two motions, and at its end', () => {
    expect(eyeAt(1_900)).toEqual([-600, 0, 0]);
    expect(eyeAt(5_000)).toEqual([0, 600, 0]);
  });

  it('jumps where there is no way between two cameras', () => {
    const opposite: Camera = { ...camera, eye_mm: [0, 600, 0] };
    expect(mixCameras(camera, opposite, 0.5)).toEqual(opposite);
    const flat: Camera = { projection: 'orthographic', view_height_mm: 100, ...placeOf(camera) };
    expect(mixCameras(camera, flat, 0.5).projection).toBe('perspective');
    const wider = mixCameras(flat, { ...flat, view_height_mm: 200 }, 0.5);
    expect(wider).toMatchObject({ view_height_mm: 150 });
  });

  it('has as many frames as its time asks for', () => {
    const film = pathFilm(path, 10);
    expect(film.frames).toBe(21);
    expect(eyeOf(film.sceneOf(20))).toEqual([0, 600, 0]);
  });

  const placeOf = ({ eye_mm, target_mm, up }: Camera) => ({ eye_mm, target_mm, up });
});

describe('the pipeline', () => {
  it('makes a few ahead and gives them in order', async () => {
    const made: number[] = [];
    const make = (index: number) => {
      made.push(index);
      return Promise.resolve(index);
    };
    const seen: number[][] = [];
    for await (const item of pipelined(4, 2, make)) seen.push([item, made.length]);
    expect(seen).toEqual([
      [0, 3],
      [1, 4],
      [2, 4],
      [3, 4],
    ]);
  });

  it('ends with the first that fails', async () => {
    const make = (index: number) =>
      index === 1 ? Promise.reject(new Error('no')) : Promise.resolve(index);
    const seen: number[] = [];
    const use = async () => {
      for await (const item of pipelined(9, 2, make)) seen.push(item);
    };
    await expect(use()).rejects.toThrow('no');
    expect(seen).toEqual([0]);
  });
});

/** The smallest picture there is: one black pixel. */
const PIXEL = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg==',
  'base64',
);

describe('notes in a PNG', () => {
  const bytesOf = async (blob: Blob) => Buffer.from(await blob.arrayBuffer());

  it('leave its chunks as they were', async () => {
    const notes = { disclaimer: 'Nicht für Ärzte', dots_per_inch: 300 };
    const noted = await bytesOf(await withNotes(new Blob([PIXEL]), notes));
    expect(noted.subarray(0, 33)).toEqual(PIXEL.subarray(0, 33));
    expect(noted.subarray(-PIXEL.length + 33)).toEqual(PIXEL.subarray(33));
    const added = noted.subarray(33, noted.length - PIXEL.length + 33);
    expect(added.toString('utf8')).toContain('Disclaimer\0\0\0\0\0Nicht für Ärzte');
    expect(added.readUInt32BE(0)).toBe(9);
    expect(added.readUInt32BE(8)).toBe(11_811);
  });

  it('have the check sums of the specification', async () => {
    const noted = await bytesOf(await withNotes(new Blob([PIXEL]), { disclaimer: 'x' }));
    const length = noted.readUInt32BE(33);
    const stored = noted.readUInt32BE(33 + 8 + length);
    expect(stored).toBe(crcOf(noted.subarray(37, 41 + length)));
  });

  it('are not put into what is no PNG', async () => {
    const text = new Blob(['text']);
    expect(await withNotes(text, { disclaimer: 'x' })).toBe(text);
  });
});

/** By the polynomial's long division, bit by bit. */
function crcOf(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes)
    for (let bit = 0; bit < 8; bit++) {
      const carry = (crc ^ (byte >> bit)) & 1;
      crc = (crc >>> 1) ^ (carry ? 0xedb88320 : 0);
    }
  return ~crc >>> 0;
}

describe('a ZIP of pictures', () => {
  it('has them numbered and as they are, after the notice', async () => {
    const pictures = vi.fn(async function* () {
      yield await Promise.resolve(new Blob(['first']));
      yield new Blob(['second']);
    });
    const settings = { size: view, frames_per_second: 25, notice: 'Not for diagnostic use' };
    const zip = await zipFile(pictures(), settings);
    const text = Buffer.from(await zip.arrayBuffer()).toString('latin1');
    expect(text).toMatch(/notice\.txt[^]*frame_00001\.png[^]*first[^]*frame_00002\.png[^]*second/);
    expect(text).toContain('Not for diagnostic use\nCutaway, 25 fps');
  });
});
