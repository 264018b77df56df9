// Pictures to a video, by the browser's own encoders. Imported only once a film is wanted: what
// writes the files is large.
import {
  BufferTarget,
  CanvasSource,
  canEncodeVideo,
  Mp4OutputFormat,
  Output,
  Quality,
  WebMOutputFormat,
} from 'mediabunny';
import type { Viewport } from '../view/camera.ts';
import type { FilmFileSettings } from './film_file.ts';

const QUALITY = new Quality('high');

export type VideoContainer = 'mp4' | 'webm';
export type VideoCodec = 'avc' | 'hevc' | 'vp9' | 'av1' | 'vp8';

/** Those that most players know first. */
const CODECS: Readonly<Record<VideoContainer, readonly VideoCodec[]>> = {
  mp4: ['avc', 'hevc', 'av1', 'vp9'],
  webm: ['vp9', 'vp8', 'av1'],
};

/** Nothing where this browser encodes none of them at that size. */
export async function bestCodec(
  container: VideoContainer,
  { width_px: width, height_px: height }: Viewport,
  frameRate: number,
): Promise<VideoCodec | undefined> {
  const options = { width, height, frameRate, quality: QUALITY };
  for (const codec of CODECS[container]) if (await canEncodeVideo(codec, options)) return codec;
  return undefined;
}

/** Holds the whole file in memory until it is done. */
export async function videoFile(
  frames: AsyncIterable<Blob>,
  container: VideoContainer,
  codec: VideoCodec,
  { size, frames_per_second, notice }: FilmFileSettings,
): Promise<Blob> {
  const sheet = new FilmSheet(size, notice);
  const target = new BufferTarget();
  const format = container === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat();
  const output = new Output({ format, target });
  const source = new CanvasSource(sheet.canvas, { codec, quality: QUALITY });
  output.addVideoTrack(source, { frameRate: frames_per_second });
  try {
    await output.start();
    let index = 0;
    for await (const frame of frames) {
      await sheet.draw(frame);
      await source.add(index / frames_per_second, 1 / frames_per_second);
      index += 1;
    }
    await output.finalize();
  } catch (error) {
    await output.cancel();
    throw error;
  }
  return new Blob(target.buffer ? [target.buffer] : [], { type: `video/${container}` });
}

/** Of the picture's height, with a least size that can be read. */
const NOTICE_SHARE = 1 / 44;
const SMALLEST_NOTICE_PX = 11;

/** What a frame is drawn on, with the notice in its lower right corner. */
class FilmSheet {
  readonly canvas: OffscreenCanvas;
  private readonly context: OffscreenCanvasRenderingContext2D;

  constructor(
    private readonly size: Viewport,
    private readonly notice: string,
  ) {
    this.canvas = new OffscreenCanvas(size.width_px, size.height_px);
    const context = this.canvas.getContext('2d', { alpha: false });
    if (!context) throw new Error('this browser offers no 2-D drawing');
    this.context = context;
  }

  async draw(frame: Blob): Promise<void> {
    const picture = await createImageBitmap(frame);
    this.context.drawImage(picture, 0, 0, this.size.width_px, this.size.height_px);
    picture.close();
    this.drawNotice();
  }

  /** Light with a dark rim, so that it can be read on any picture. */
  private drawNotice(): void {
    const { context, size, notice } = this;
    const letter_px = Math.max(SMALLEST_NOTICE_PX, Math.round(size.height_px * NOTICE_SHARE));
    const place = [size.width_px - letter_px, size.height_px - letter_px] as const;
    context.font = `500 ${letter_px}px system-ui, sans-serif`;
    context.textAlign = 'right';
    context.textBaseline = 'alphabetic';
    context.lineJoin = 'round';
    context.lineWidth = letter_px / 5;
    context.strokeStyle = 'rgb(0 0 0 / 55%)';
    context.strokeText(notice, ...place);
    context.fillStyle = 'rgb(255 255 255 / 85%)';
    context.fillText(notice, ...place);
  }
}
