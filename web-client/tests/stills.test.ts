// Stills that the server refuses for now, or whose connection is lost.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Counter } from '../src/protocol/counter.ts';
import type { ClientMessage, ErrorMessage } from '../src/protocol/messages.ts';
import { Stills } from '../src/session/stills.ts';

const size = { width_px: 64, height_px: 48 };
const png = new Blob(['png']);

let sent: ClientMessage[];
let told: boolean[];
let stills: Stills;
beforeEach(() => {
  vi.useFakeTimers();
  sent = [];
  told = [];
  const stream = { send: (message: ClientMessage) => sent.push(message), connectNow: vi.fn() };
  stills = new Stills(stream, new Counter(), { flush: vi.fn() }, (lags) => told.push(lags));
  stills.served();
});
afterEach(() => {
  vi.useRealTimers();
});

const requests = () => sent.flatMap((one) => (one.type === 'save_still' ? one.request : []));
const make = (signal = new AbortController().signal) => stills.make(size, signal);
const refuse = (request: number | undefined, code: ErrorMessage['code'] = 'rate-limited') =>
  stills.refused({
    type: 'error',
    code,
    message: 'Not now',
    ...(request !== undefined && { request }),
  });

describe('a still that is refused for now', () => {
  it('is asked for again after a pause, and comes', async () => {
    const made = make();
    expect(refuse(1)).toBe(true);
    expect(requests()).toEqual([1]);
    expect(told.at(-1)).toBe(true);
    vi.runOnlyPendingTimers();
    expect(requests()).toEqual([1, 2]);
    expect(told.at(-1)).toBe(false);
    stills.arrived(2, png);
    expect(await made).toBe(png);
  });

  it('keeps its place in front of those that came later', () => {
    void make();
    void make();
    void stills.make({ ...size, view: 1 }, new AbortController().signal);
    refuse(2);
    stills.arrived(1, png);
    vi.runOnlyPendingTimers();
    expect(sent.map((one) => 'view' in one)).toEqual([false, false, false, true]);
  });

  it('is asked for ever more seldom, and given up in the end with the server’s reason', async () => {
    const failing = expect(make()).rejects.toMatchObject({ title: 'Too many requests' });
    const pauses: number[] = [];
    for (let before = Date.now(); requests().length < 40; before = Date.now()) {
      refuse(requests().at(-1));
      if (vi.getTimerCount() === 0) break;
      vi.runOnlyPendingTimers();
      pauses.push(Date.now() - before);
    }
    await failing;
    expect(pauses.slice(0, 3)).toEqual([250, 500, 1000]);
    expect(pauses.at(-1)).toBe(8000);
    expect(pauses).toHaveLength(12);
    expect(told.at(-1)).toBe(false);
  });

  it('survives a refusal that names no request', async () => {
    const made = Promise.all([make(), make()]);
    expect(refuse(undefined)).toBe(false);
    vi.runOnlyPendingTimers();
    expect(requests()).toEqual([1, 2, 3, 4]);
    stills.arrived(3, png);
    stills.arrived(4, png);
    expect(await made).toHaveLength(2);
  });

  it('is not asked for again once it was given up', async () => {
    const user = new AbortController();
    const failing = expect(make(user.signal)).rejects.toThrow();
    refuse(1);
    user.abort();
    await failing;
    expect(told.at(-1)).toBe(false);
    vi.runOnlyPendingTimers();
    expect(requests()).toEqual([1]);
  });

  it('fails at once where time changes nothing', async () => {
    const failing = expect(make()).rejects.toMatchObject({ detail: 'Not now.' });
    refuse(1, 'too-large');
    await failing;
    expect(vi.getTimerCount()).toBe(0);
  });

  it('takes its time where the renderer gave it up', async () => {
    const made = make();
    refuse(1, 'render-failed');
    vi.runOnlyPendingTimers();
    stills.arrived(2, png);
    expect(await made).toBe(png);
  });
});

describe('stills of a lost connection', () => {
  it('are asked for again, in their order, once the server shows the scene', async () => {
    const made = Promise.all([make(), make(), make()]);
    stills.interrupted();
    expect(told.at(-1)).toBe(true);
    stills.interrupted();
    expect(requests()).toEqual([1, 2]);
    stills.served();
    expect(requests()).toEqual([1, 2, 3, 4]);
    for (const request of [3, 4, 5]) stills.arrived(request, png);
    expect(await made).toHaveLength(3);
  });

  it('do not wait for a pause that the old one had', () => {
    void make();
    refuse(1);
    stills.interrupted();
    stills.served();
    expect(requests()).toEqual([1, 2]);
    expect(vi.getTimerCount()).toBe(0);
  });
});
