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
import type { FilmFrame } from './film.ts';
import type { FrameSheet } from './labelled_pictures.ts';

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

/** Each frame as `sheet` draws it. Holds the whole file in memory until it is done. */
export async function videoFile(
  frames: AsyncIterable<FilmFrame>,
  container: VideoContainer,
  codec: VideoCodec,
  sheet: FrameSheet,
  frames_per_second: number,
): Promise<Blob> {
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
