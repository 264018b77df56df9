import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { Counter, isAfter } from '../src/protocol/counter.ts';
import { decodeFrame, FrameHeaderError } from '../src/protocol/frame_header.ts';
import { ReconnectBackoff } from '../src/protocol/reconnect_backoff.ts';
import { FrameQueue } from '../src/stream/frame_queue.ts';

interface FrameFields {
  length?: number;
  version?: number;
  type?: number;
  flags?: number;
  frame?: number;
  announced?: number;
}

/** A frame as protocol/README.md lays it out, with a picture of four bytes. */
function frameBytes({
  length = 56,
  version = 1,
  type = 1,
  flags = 0,
  frame = 7,
  announced = 4,
}: FrameFields = {}): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(length + 4));
  new TextEncoder().encode('CTWF').forEach((letter, index) => view.setUint8(index, letter));
  view.setUint8(4, version);
  view.setUint8(5, type);
  view.setUint8(6, flags);
  view.setUint16(8, length, true);
  view.setUint16(10, 2, true);
  view.setUint32(12, frame, true);
  view.setUint32(16, 21, true);
  view.setUint32(20, 4_000_000_000, true);
  view.setFloat64(24, 1234.5, true);
  view.setUint32(32, 8000, true);
  view.setUint32(36, 900, true);
  [640, 480, 1280, 960].forEach((side, index) => view.setUint16(40 + 2 * index, side, true));
  view.setUint32(48, announced, true);
  new Uint8Array(view.buffer).set([1, 2, 3, 4], length);
  return view.buffer;
}

const fixture_folder = fileURLToPath(
  new URL('../../protocol/fixtures/frame_header/', import.meta.url),
);
const binaryFixtures = (kind: 'valid' | 'invalid'): string[] =>
  readdirSync(`${fixture_folder}${kind}`).filter((name) => name.endsWith('.bin'));
/** In a buffer of its own, as a WebSocket gives it. */
const bytesOf = (path: string): ArrayBuffer =>
  new Uint8Array(readFileSync(`${fixture_folder}${path}`)).buffer;

describe('the frame header in the protocol’s fixtures', () => {
  it.each(binaryFixtures('valid'))('is read: %s', (name) => {
    const text = readFileSync(`${fixture_folder}valid/${name.replace('.bin', '.json')}`, 'utf8');
    const { picture: expected_picture, ...expected } = JSON.parse(text) as { picture: number[] };
    const { header, picture } = decodeFrame(bytesOf(`valid/${name}`));
    expect(header).toEqual(expected);
    expect([...picture]).toEqual(expected_picture);
  });

  it.each(binaryFixtures('invalid'))('is refused: %s', (name) => {
    expect(() => decodeFrame(bytesOf(`invalid/${name}`))).toThrow(FrameHeaderError);
  });
});

describe('the frame header', () => {
  it('is read field by field', () => {
    const { header, picture } = decodeFrame(frameBytes({ flags: 1 }));
    expect(header).toEqual({
      type: 'live',
      still: true,
      lossless: false,
      view: 2,
      frame: 7,
      revision: 21,
      input: 4_000_000_000,
      clock_ms: 1234.5,
      render_us: 8000,
      encode_us: 900,
      width_px: 640,
      height_px: 480,
      viewport_width_px: 1280,
      viewport_height_px: 960,
    });
    expect([...picture]).toEqual([1, 2, 3, 4]);
  });

  it('may grow', () => {
    expect([...decodeFrame(frameBytes({ length: 72, version: 2 })).picture]).toEqual([1, 2, 3, 4]);
  });

  it('tells a saved still', () => {
    expect(decodeFrame(frameBytes({ type: 2, flags: 3 })).header).toMatchObject({
      type: 'saved_still',
      lossless: true,
    });
  });

  it('tells a preview, whose frame number is its request', () => {
    expect(decodeFrame(frameBytes({ type: 3, frame: 12 })).header).toMatchObject({
      type: 'preview',
      frame: 12,
    });
  });

  it('is refused where it is no frame or not a whole one', () => {
    const other_magic = frameBytes();
    new Uint8Array(other_magic).set([0], 0);
    const broken = [
      new ArrayBuffer(0),
      frameBytes().slice(0, 55),
      other_magic,
      frameBytes({ announced: 5 }),
      frameBytes({ type: 9 }),
      frameBytes({ length: 56 }).slice(0, 58),
    ];
    for (const message of broken) expect(() => decodeFrame(message)).toThrow(FrameHeaderError);
    const short_header = frameBytes({ version: 2 });
    new DataView(short_header).setUint16(8, 40, true);
    expect(() => decodeFrame(short_header)).toThrow('header version 2 announces 40 bytes');
  });
});

describe('the frame queue', () => {
  const frame = (number: number) => decodeFrame(frameBytes({ frame: number }));

  it('keeps the newest undecoded frame only', () => {
    const queue = new FrameQueue();
    expect(queue.offer(frame(1)) && queue.offer(frame(2))).toBe(true);
    expect(queue.take()?.header.frame).toBe(2);
    expect(queue.take()).toBeUndefined();
  });

  it('never takes an older frame, not even after the newer was taken', () => {
    const queue = new FrameQueue();
    queue.offer(frame(5));
    queue.take();
    expect(queue.offer(frame(4)) || queue.offer(frame(5))).toBe(false);
    expect(queue.take()).toBeUndefined();
  });

  it('goes on where the numbers wrap around', () => {
    const queue = new FrameQueue();
    queue.offer(frame(0xffff_ffff));
    expect(queue.offer(frame(0))).toBe(true);
  });

  it('starts anew with a session', () => {
    const queue = new FrameQueue();
    queue.offer(frame(90));
    queue.restart();
    expect(queue.take()).toBeUndefined();
    expect(queue.offer(frame(1))).toBe(true);
  });
});

describe('counters', () => {
  it('count from 1', () => {
    const counter = new Counter();
    expect([counter.next(), counter.next()]).toEqual([1, 2]);
  });

  it('compare across the wrap', () => {
    expect(isAfter(3, 2)).toBe(true);
    expect(isAfter(2, 2)).toBe(false);
    expect(isAfter(0, 0xffff_fffe)).toBe(true);
    expect(isAfter(0xffff_fffe, 0)).toBe(false);
  });
});

describe('the wait before a new attempt', () => {
  it('doubles up to a limit', () => {
    const backoff = new ReconnectBackoff(() => 1);
    const waits_ms = Array.from({ length: 8 }, () => backoff.nextDelayMs());
    expect(waits_ms).toEqual([250, 500, 750, 750, 750, 750, 750, 750]);
  });

  it('grows longer where the server is full', () => {
    const backoff = new ReconnectBackoff(() => 1);
    const waits_ms = Array.from({ length: 8 }, () => backoff.nextDelayMs(true));
    expect(waits_ms).toEqual([250, 500, 1000, 2000, 4000, 8000, 15000, 15000]);
  });

  it('is spread over half of itself', () => {
    expect(new ReconnectBackoff(() => 0).nextDelayMs()).toBe(125);
  });

  it('begins anew after a connection that worked', () => {
    const backoff = new ReconnectBackoff(() => 1);
    backoff.nextDelayMs();
    backoff.nextDelayMs();
    backoff.reset();
    expect(backoff.nextDelayMs()).toBe(250);
  });
});
