// The kinds of file that a film can be, and which of them this browser can write.
import type { Viewport } from '../view/camera.ts';
import type { FilmFrame } from './film.ts';
import type { Labelling } from './labelled_pictures.ts';
import { withNotes } from './png_notes.ts';
import type { VideoCodec } from './video_file.ts';

export const FILM_FORMATS = ['mp4', 'webm', 'zip'] as const;
export type FilmFormat = (typeof FILM_FORMATS)[number];

/** Why a format is not there. */
export type MissingReason = 'insecure' | 'no_encoder' | 'no_codec';

export type FormatSupport =
  | { readonly format: FilmFormat; readonly codec?: VideoCodec }
  | { readonly format: FilmFormat; readonly missing: MissingReason };

export interface FilmFileSettings {
  readonly size: Viewport;
  readonly frames_per_second: number;
  /** Is seen in every video, and lies beside numbered pictures. */
  readonly notice: string;
  /** Left out, numbered pictures stay the server's, and a video has the notice alone. */
  readonly labelling?: Labelling;
}

/** Browsers hide their encoders from pages that came over an open connection. */
function encodersMissing(): MissingReason | undefined {
  if ('VideoEncoder' in globalThis) return undefined;
  return globalThis.isSecureContext ? 'no_encoder' : 'insecure';
}

/** For a film of that size and speed, in the order to offer them. */
export async function formatSupport(
  size: Viewport,
  frames_per_second: number,
): Promise<readonly FormatSupport[]> {
  const missing = encodersMissing();
  if (missing)
    return FILM_FORMATS.map((format) => (format === 'zip' ? { format } : { format, missing }));
  const { bestCodec } = await import('./video_file.ts');
  // WebKitGTK looks for its codecs at the first such question, and ends the page when asked for an
  // encoder before.
  document.createElement('video').canPlayType('video/mp4');
  return Promise.all(
    FILM_FORMATS.map(async (format): Promise<FormatSupport> => {
      if (format === 'zip') return { format };
      const codec = await bestCodec(format, size, frames_per_second);
      return codec ? { format, codec } : { format, missing: 'no_codec' };
    }),
  );
}

/** Ends early, and frees what it holds, where the frames fail. */
export async function filmFile(
  frames: AsyncIterable<FilmFrame>,
  { format, codec }: { readonly format: FilmFormat; readonly codec?: VideoCodec },
  settings: FilmFileSettings,
): Promise<Blob> {
  if (format !== 'zip' && codec) {
    const { size, notice, labelling, frames_per_second } = settings;
    const [{ videoFile }, { FrameSheet }] = await Promise.all([
      import('./video_file.ts'),
      import('./labelled_pictures.ts'),
    ]);
    const sheet = new FrameSheet(size, notice, labelling);
    return videoFile(frames, format, codec, sheet, frames_per_second);
  }
  const { zipFile } = await import('./zip_file.ts');
  return zipFile(numbered(frames, settings), settings);
}

async function* numbered(
  frames: AsyncIterable<FilmFrame>,
  { labelling, notice: disclaimer }: FilmFileSettings,
): AsyncGenerator<Blob> {
  const label = labelling ? await labeller(labelling) : ({ png }: FilmFrame) => png;
  for await (const frame of frames) yield await withNotes(await label(frame), { disclaimer });
}

/** What draws the labels comes when a picture is to have some. */
export async function labeller(labelling: Labelling): Promise<(frame: FilmFrame) => Promise<Blob>> {
  const { PngLabeller } = await import('./labelled_pictures.ts');
  const one = new PngLabeller(labelling);
  return (frame) => one.label(frame);
}
