// Numbered pictures in one file, stored as they are: PNG does not get smaller.
import { downloadZip } from 'client-zip';
import type { FilmFileSettings } from './film_file.ts';

const DIGITS = 5;

interface Entry {
  readonly name: string;
  readonly input: Blob | string;
}

/** `frame_00001.png` and so on, and what they are in words. */
async function* entries(
  frames: AsyncIterable<Blob>,
  { frames_per_second, notice }: FilmFileSettings,
): AsyncGenerator<Entry> {
  yield { name: 'notice.txt', input: `${notice}\nCutaway, ${frames_per_second} fps\n` };
  let number = 1;
  for await (const input of frames) {
    yield { name: `frame_${String(number).padStart(DIGITS, '0')}.png`, input };
    number += 1;
  }
}

export const zipFile = (frames: AsyncIterable<Blob>, settings: FilmFileSettings): Promise<Blob> =>
  downloadZip(entries(frames, settings)).blob();
