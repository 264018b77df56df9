import { beforeEach, describe, expect, it, vi } from 'vitest';
import { labelLayout, type LabelLayout, type PlacedText } from '../src/film/label_layout.ts';
import { PngLabeller } from '../src/film/labelled_pictures.ts';
import {
  pictureLabels,
  type LabelSubject,
  type PictureLabels,
} from '../src/film/picture_labels.ts';
import { turntableFilm } from '../src/film/turntable.ts';
import type { Scene } from '../src/protocol/messages.ts';
import { cameraOf } from '../src/state/scene_parts.ts';
import type { Viewport } from '../src/view/camera.ts';
import { sceneMessage, volume } from './capabilities.ts';

const NOTICE = 'Not for diagnostic use';
const size = { width_px: 800, height_px: 600 };
const subject: LabelSubject = { volume, view: '3d', size, notice: NOTICE };

const sliced = (convention: 'radiological' | 'neurological'): Scene => ({
  ...sceneMessage.scene,
  slices: {
    crosshair_mm: [0, 0, 34.5],
    convention,
    window: { centre: 40, width: 400 },
    axial: { centre_mm: [0, 0, 0], view_height_mm: 300 },
  },
});

describe('what is written on a picture', () => {
  it('tells a neurological slice from a radiological one', () => {
    const labels = (convention: 'radiological' | 'neurological'): PictureLabels =>
      pictureLabels({ ...subject, view: 'axial' }, sliced(convention));
    expect(labels('radiological')).toEqual({
      notice: NOTICE,
      title: 'Head',
      facts: ['Axial · S 34.5 mm', 'Radiological', 'W 400 · C 40'],
      letters: { top: 'A', right: 'L', bottom: 'P', left: 'R' },
      scale: { mm_per_pixel: 0.5, foreshortens: false },
    });
    expect(labels('neurological')).toMatchObject({
      facts: ['Axial · S 34.5 mm', 'Neurological', 'W 400 · C 40'],
      letters: { top: 'A', right: 'R', bottom: 'P', left: 'L' },
    });
  });

  it('has the scale of the exported size', () => {
    const wide = { width_px: 2400, height_px: 1200 };
    const { scale } = pictureLabels(
      { ...subject, view: 'axial', size: wide },
      sliced('radiological'),
    );
    expect(scale?.mm_per_pixel).toBe(0.25);
    const camera = pictureLabels(subject, sceneMessage.scene).scale;
    const larger = pictureLabels({ ...subject, size: wide }, sceneMessage.scene).scale;
    expect(larger?.mm_per_pixel).toBeCloseTo((camera?.mm_per_pixel ?? 0) / 2);
    expect(camera?.foreshortens).toBe(true);
  });

  it('follows the camera of a film', () => {
    const camera = cameraOf(sceneMessage.scene);
    if (!camera) throw new Error('the scene has no camera');
    const turn = { axis: 'superior', degrees: 360, seconds: 1, direction: 'right' } as const;
    const film = turntableFilm(sceneMessage.scene, camera, turn, 4);
    const right = [0, 1, 2, 3].map(
      (frame) => pictureLabels(subject, film.sceneOf(frame) as Scene).letters?.right,
    );
    expect(right).toEqual(['L', 'A', 'R', 'P']);
  });

  it('is the name and the notice alone while the scene leaves the view open', () => {
    expect(pictureLabels(subject, {})).toEqual({ notice: NOTICE, title: 'Head' });
    expect(pictureLabels({ ...subject, view: 'coronal' }, {}).facts).toEqual(['Coronal']);
  });
});

/** Every letter half as wide as it is high. */
const measure = (text: string, size_px: number): number => text.length * size_px * 0.5;

interface Box {
  readonly text: string;
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

function boxOf({ text, x, y, size_px, anchor }: PlacedText): Box {
  const width = measure(text, size_px);
  const left = x - { left: 0, center: width / 2, right: width }[anchor];
  return { text, left, right: left + width, top: y - size_px * 0.72, bottom: y };
}

function boxesOf({ texts, bar }: LabelLayout): Box[] {
  const boxes = texts.map(boxOf);
  if (!bar) return boxes;
  const { left, width, y, tick_px } = bar;
  return [...boxes, { text: 'bar', left, right: left + width, top: y - tick_px, bottom: y }];
}

const overlap = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

const of_slice = pictureLabels({ ...subject, view: 'axial' }, sliced('neurological'));
const of_volume = pictureLabels(subject, sceneMessage.scene);
const long_name = {
  ...of_volume,
  title: 'A thorax with a name that is longer than its picture '.repeat(4),
};

describe('where the labels stand', () => {
  const layout = (of: Viewport, labels: PictureLabels): LabelLayout =>
    labelLayout(of, labels, measure);
  const textAt = ({ texts }: LabelLayout, text: string): PlacedText | undefined =>
    texts.find((one) => one.text === text);

  it('is at the edges and in the corners', () => {
    const made = layout({ width_px: 1000, height_px: 1000 }, of_slice);
    expect(made.em_px).toBe(16);
    expect(textAt(made, 'Head')).toMatchObject({ x: 16, anchor: 'left', size_px: 16, weight: 500 });
    expect(textAt(made, 'Neurological')).toMatchObject({ x: 984, anchor: 'right' });
    expect(textAt(made, NOTICE)).toMatchObject({ x: 16, y: 984, anchor: 'left' });
    expect(textAt(made, 'A')).toMatchObject({ x: 500, anchor: 'center', weight: 700, size_px: 26 });
    expect(textAt(made, 'P')).toMatchObject({ x: 500, y: 984 });
    expect(textAt(made, 'L')).toMatchObject({ x: 16, anchor: 'left' });
    expect(textAt(made, 'R')).toMatchObject({ x: 984, anchor: 'right' });
    // 100 px of 0.5 mm.
    expect(textAt(made, '5 cm')).toMatchObject({ x: 984, anchor: 'right' });
    expect(made.bar).toMatchObject({ left: 884, y: 984, width: 100, parts: 5 });
  });

  it('says that a perspective picture’s scale holds at one depth', () => {
    const { texts } = layout({ width_px: 1600, height_px: 1200 }, of_volume);
    expect(texts.map(({ text }) => text)).toContain('10 cm at mid-depth');
  });

  it.each([
    [400, 300, 11],
    [1000, 700, 11],
    [3508, 2480, 40],
    [8192, 8192, 131],
    [8192, 500, 11],
  ])('grows with a picture of %i × %i', (width_px, height_px, em_px) => {
    expect(layout({ width_px, height_px }, of_slice).em_px).toBe(em_px);
  });

  const sizes: Viewport[] = [
    { width_px: 8192, height_px: 8192 },
    { width_px: 3000, height_px: 2000 },
    { width_px: 800, height_px: 600 },
    { width_px: 400, height_px: 400 },
    { width_px: 300, height_px: 200 },
    { width_px: 160, height_px: 120 },
    { width_px: 120, height_px: 1000 },
    { width_px: 1000, height_px: 120 },
    { width_px: 66, height_px: 66 },
    { width_px: 20, height_px: 20 },
  ];
  const subjects = { of_slice, of_volume, long_name };
  const cases = sizes.flatMap((of) =>
    Object.entries(subjects).map(([name, labels]) => ({ ...of, name, labels })),
  );

  it.each(cases)('$name in $width_px × $height_px px: inside, apart, with the notice', (one) => {
    const boxes = boxesOf(layout(one, one.labels));
    for (const { left, right, top, bottom, text } of boxes) {
      expect(left, text).toBeGreaterThanOrEqual(0);
      expect(right, text).toBeLessThanOrEqual(one.width_px);
      expect(top, text).toBeGreaterThanOrEqual(0);
      expect(bottom, text).toBeLessThanOrEqual(one.height_px);
    }
    const pairs = boxes.flatMap((a, at) => boxes.slice(at + 1).map((b) => [a, b] as const));
    const overlapping = pairs.filter(([a, b]) => overlap(a, b)).map(([a, b]) => [a.text, b.text]);
    expect(overlapping).toEqual([]);
    expect(boxes.map(({ text }) => text)).toContain(NOTICE);
  });

  it('has the four letters wherever there is room for more than the notice', () => {
    for (const of of sizes.slice(0, -1)) {
      const texts = layout(of, of_slice).texts.map(({ text }) => text);
      expect(texts, `${of.width_px} × ${of.height_px}`).toEqual(
        expect.arrayContaining(['A', 'P', 'L', 'R']),
      );
    }
  });
});

describe('a browser that has no canvas of that size', () => {
  const png = new Blob(['png']);
  beforeEach(() => void vi.unstubAllGlobals());

  it('leaves the pictures as they came, and says so once', async () => {
    const refused = vi.fn();
    const labeller = new PngLabeller({ subject, refused });
    expect(await labeller.label({ png, scene: sceneMessage.scene })).toBe(png);
    expect(await labeller.label({ png, scene: sceneMessage.scene })).toBe(png);
    expect(refused).toHaveBeenCalledOnce();
  });

  it('that comes empty is found out', async () => {
    const context = new Proxy(
      { getImageData: () => ({ data: [0, 0, 0, 0] }) },
      {
        get: (known, name) => (Reflect.get(known, name) as unknown) ?? (() => ({ width: 1 })),
      },
    ) as unknown;
    class Canvas {
      getContext = () => context;
    }
    vi.stubGlobal('OffscreenCanvas', Canvas);
    vi.stubGlobal(
      'Path2D',
      class {
        moveTo() {}
        lineTo() {}
      },
    );
    vi.stubGlobal('createImageBitmap', () => Promise.resolve({ close: () => undefined }));
    const refused = vi.fn();
    const labeller = new PngLabeller({ subject, refused });
    expect(await labeller.label({ png, scene: sceneMessage.scene })).toBe(png);
    expect(refused).toHaveBeenCalledOnce();
  });
});
