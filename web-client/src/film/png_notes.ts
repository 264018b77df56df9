// Notes in a PNG file (PNG specification, 11.3.3 and 11.3.4.3), added between its chunks: not a bit
// of the picture changes.

/** Signature and header chunk, which come first in every file. */
const HEADER_BYTES = 33;
const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const CRC_POLYNOMIAL = 0xedb88320;
const METRES_PER_INCH = 0.0254;

function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ CRC_POLYNOMIAL : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}

const asciiBytes = (text: string): Uint8Array =>
  Uint8Array.from(text, (letter) => letter.charCodeAt(0));

function chunk(type: string, ...parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const typed = [asciiBytes(type), ...parts];
  const length = typed.reduce((sum, part) => sum + part.length, 0);
  const bytes = new Uint8Array(length + 8);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, length - 4);
  let at = 4;
  for (const part of typed) {
    bytes.set(part, at);
    at += part.length;
  }
  view.setUint32(at, crc32(bytes.subarray(4, at)));
  return bytes;
}

/** Uncompressed, of no stated language, in UTF-8. */
const textChunk = (keyword: string, text: string): Uint8Array<ArrayBuffer> =>
  chunk('iTXt', asciiBytes(`${keyword}\0\0\0\0\0`), new TextEncoder().encode(text));

function resolutionChunk(dots_per_inch: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(9);
  const view = new DataView(bytes.buffer);
  const dots_per_metre = Math.round(dots_per_inch / METRES_PER_INCH);
  view.setUint32(0, dots_per_metre);
  view.setUint32(4, dots_per_metre);
  view.setUint8(8, 1);
  return chunk('pHYs', bytes);
}

export interface PngNotes {
  /** What the picture is not for. */
  readonly disclaimer: string;
  readonly dots_per_inch?: number;
}

/** What is no PNG is given back as it is. */
export async function withNotes(png: Blob, { disclaimer, dots_per_inch }: PngNotes): Promise<Blob> {
  const header = new Uint8Array(await png.slice(0, HEADER_BYTES).arrayBuffer());
  if (!SIGNATURE.every((byte, index) => header[index] === byte)) return png;
  const notes = [
    ...(dots_per_inch === undefined ? [] : [resolutionChunk(dots_per_inch)]),
    textChunk('Software', 'Cutaway'),
    textChunk('Disclaimer', disclaimer),
  ];
  const parts = [png.slice(0, HEADER_BYTES), ...notes, png.slice(HEADER_BYTES)];
  return new Blob(parts, { type: 'image/png' });
}
