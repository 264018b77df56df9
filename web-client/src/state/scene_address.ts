// The scene in the page's address: '#1.' and the document, deflated, in URL-safe base64. Numbers
// keep seven digits, which is a thousandth of a millimetre at ten metres.
import { isObject, omit, type Json, type JsonObject } from './merge_patch.ts';
import type { Words } from '../words/words.ts';

const FORMAT = '1';
const DIGITS = 7;
/** A longer document than any message may be is no scene. */
const LARGEST_BYTES = 64 * 1024;

export type LinkFault = keyof Words['messages']['link_faults'];

export class SceneAddressError extends Error {
  constructor(readonly fault: LinkFault) {
    super(fault);
  }
}

function rounded(_key: string, value: Json): Json {
  return typeof value === 'number' ? Number(value.toPrecision(DIGITS)) : value;
}

const toBase64Url = (bytes: Uint8Array): string =>
  btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replaceAll('=', '');

const fromBase64Url = (text: string): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) =>
    letter.charCodeAt(0),
  );

function pipe(
  bytes: Uint8Array<ArrayBuffer>,
  through: CompressionStream | DecompressionStream,
): ReadableStream<Uint8Array> {
  return new Blob([bytes]).stream().pipeThrough(through);
}

/** Reads to the end, but never more than the limit: a few bytes can inflate to gigabytes. */
async function readLimited(stream: ReadableStream<Uint8Array>): Promise<string> {
  const reader = stream.getReader();
  const decoder = new TextDecoder('utf-8', { fatal: true });
  let text = '';
  for (let chunk = await reader.read(); !chunk.done; chunk = await reader.read()) {
    text += decoder.decode(chunk.value, { stream: true });
    if (text.length > LARGEST_BYTES) {
      await reader.cancel();
      throw new SceneAddressError('too_large');
    }
  }
  return text + decoder.decode();
}

export async function sceneToAddress(scene: JsonObject): Promise<string> {
  // The size of the picture belongs to a window, not to a link.
  const bytes = new TextEncoder().encode(JSON.stringify(omit(scene, ['viewport']), rounded));
  const deflated = await new Response(
    pipe(bytes, new CompressionStream('deflate-raw')),
  ).arrayBuffer();
  return `#${FORMAT}.${toBase64Url(new Uint8Array(deflated))}`;
}

async function inflateDocument(payload: string): Promise<unknown> {
  try {
    return JSON.parse(
      await readLimited(pipe(fromBase64Url(payload), new DecompressionStream('deflate-raw'))),
    );
  } catch (error) {
    if (error instanceof SceneAddressError) throw error;
    throw new SceneAddressError('damaged');
  }
}

/**
 * Nothing for an address without a scene. Throws SceneAddressError where there is one that cannot
 * be read.
 */
export async function sceneFromAddress(hash: string): Promise<JsonObject | undefined> {
  if (hash.length <= 1) return undefined;
  const [format, payload] = hash.slice(1).split('.', 2);
  if (format !== FORMAT || !payload) throw new SceneAddressError('unknown_form');
  const scene = await inflateDocument(payload);
  if (!isObject(scene)) throw new SceneAddressError('no_scene');
  return scene;
}
