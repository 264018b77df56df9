// The kinds of file that a film can be, and which of them this browser can write.
import type { Viewport } from '../view/camera.ts';
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
  /** Is seen in a video, and lies beside numbered pictures, whose pixels stay the server's. */
  readonly notice: string;
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
  return Promise.all(
    FILM_FORMATS.map(async (format): Promise<FormatSupport> => {
      if (format === 'zip') return { format };
      const codec = await bestCodec(format, size, frames_per_second);
      return codec ? { format, codec } : { format, missing: 'no_codec' };
    }),
  );
}

/** `frames` are PNG. Ends early, and frees what it holds, where they fail. */
export async function filmFile(
  frames: AsyncIterable<Blob>,
  { format, codec }: { readonly format: FilmFormat; readonly codec?: VideoCodec },
  settings: FilmFileSettings,
): Promise<Blob> {
  if (format !== 'zip' && codec) {
    const { videoFile } = await import('./video_file.ts');
    return videoFile(frames, format, codec, settings);
  }
  const { zipFile } = await import('./zip_file.ts');
  return zipFile(noted(frames, settings.notice), settings);
}

async function* noted(frames: AsyncIterable<Blob>, disclaimer: string): AsyncGenerator<Blob> {
  for await (const frame of frames) yield await withNotes(frame, { disclaimer });
}
