// What is in a file that the page has saved.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

const clientRequire = createRequire(
  new URL('../../../../web-client/package.json', import.meta.url),
);

/** Name and bytes of what `action` makes the page save. */
export async function download({ page }, action) {
  const coming = page.waitForEvent('download');
  await action();
  const file = await coming;
  return {
    name: file.suggestedFilename(),
    bytes: await readFile(await file.path()),
  };
}

/** Decoded by the browser: its size, and how many of a few hundred places differ from the first. */
export function pictureFacts({ page }, bytes) {
  return page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([data], { type: 'image/png' }));
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(20, 20).getContext('2d');
    context.drawImage(bitmap, 0, 0, 20, 20);
    const pixels = context.getImageData(0, 0, 20, 20).data;
    let others = 0;
    for (let at = 0; at < pixels.length; at += 4)
      if ([0, 1, 2].some((part) => Math.abs(pixels[at + part] - pixels[part]) > 16)) others += 1;
    return { width, height, others };
  }, bytes.toString('base64'));
}

/**
 * Of two pictures of one size: how many pixels differ near the edges, and how many in the middle,
 * which begins a sixth of the way in from each edge.
 */
export function differences({ page }, one, other) {
  const compare = async (texts) => {
    const pictures = texts.map(async (base64) => {
      const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([data], { type: 'image/png' }));
      const { width, height } = bitmap;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      return { width, height, pixels: context.getImageData(0, 0, width, height).data };
    });
    const [a, b] = await Promise.all(pictures);
    const { width, height } = a;
    const isInside = (at, side) => at >= side / 6 && at < (side * 5) / 6;
    const found = { edges: 0, middle: 0 };
    for (let at = 0; at < a.pixels.length; at += 4) {
      if ([0, 1, 2, 3].every((part) => a.pixels[at + part] === b.pixels[at + part])) continue;
      const [x, y] = [(at / 4) % width, Math.floor(at / 4 / width)];
      found[isInside(x, width) && isInside(y, height) ? 'middle' : 'edges'] += 1;
    }
    return found;
  };
  return page.evaluate(
    compare,
    [one, other].map((bytes) => bytes.toString('base64')),
  );
}

/** Of a video: its codec, size, number of frames and length. */
export async function videoFacts(bytes) {
  const { ALL_FORMATS, BufferSource, Input } = clientRequire('mediabunny');
  const input = new Input({
    formats: ALL_FORMATS,
    source: new BufferSource(bytes),
  });
  const track = await input.getPrimaryVideoTrack();
  const { packetCount } = await track.computePacketStats();
  return {
    codec: await track.getCodec(),
    width: await track.getDisplayWidth(),
    height: await track.getDisplayHeight(),
    frames: packetCount,
    seconds: await track.computeDuration(),
  };
}

const CENTRAL_ENTRY = 0x02014b50;
const STORED = 0;

/** Entries of a ZIP, by its directory; all of them stored as they are. */
export function zipEntries(bytes) {
  const end = bytes.lastIndexOf(Buffer.from('PK\x05\x06', 'latin1'));
  const entries = [];
  for (let at = bytes.readUInt32LE(end + 16); bytes.readUInt32LE(at) === CENTRAL_ENTRY;) {
    const [name_length, extra, comment] = [28, 30, 32].map((field) =>
      bytes.readUInt16LE(at + field),
    );
    const size = bytes.readUInt32LE(at + 24);
    const local = bytes.readUInt32LE(at + 42);
    const start = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
    entries.push({
      name: bytes.toString('utf8', at + 46, at + 46 + name_length),
      is_stored: bytes.readUInt16LE(at + 10) === STORED,
      content: bytes.subarray(start, start + size),
    });
    at += 46 + name_length + extra + comment;
  }
  return entries;
}
