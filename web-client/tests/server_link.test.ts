import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { ServerLink } from '../src/stream/server_link.ts';
import type { LinkState } from '../src/stream/worker_messages.ts';

/** A socket that does what the test says. */
class Socket {
  static readonly OPEN = 1;
  static made: Socket[] = [];
  readyState = 0;
  is_closed = false;
  onopen: (() => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  onmessage: (() => void) | null = null;

  constructor() {
    Socket.made.push(this);
  }

  close(): void {
    this.is_closed = true;
  }
}

describe('the connection', () => {
  let states: LinkState[];
  let link: ServerLink;
  const newest = () => Socket.made.at(-1) as Socket;
  const phases = () => states.map(({ phase }) => phase);

  beforeEach(() => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
    vi.stubGlobal('WebSocket', Socket);
    Socket.made = [];
    states = [];
    link = new ServerLink('ws://x/ws', {
      onLinkState: (state) => states.push(state),
      onText: () => undefined,
      onBinary: () => undefined,
    });
    link.connect();
  });

  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it('gives up an attempt that hangs, says why, and tries again', () => {
    const hangs = newest();
    vi.advanceTimersByTime(4_000);
    expect(hangs.is_closed).toBe(true);
    expect(Socket.made).toHaveLength(2);
    expect(states).toMatchObject([
      { phase: 'connecting' },
      { phase: 'waiting', reason: 'no_answer' },
      { phase: 'connecting', reason: 'no_answer' },
    ]);
  });

  it('lets a later attempt take longer', () => {
    vi.advanceTimersByTime(4_000);
    const second = newest();
    vi.advanceTimersByTime(4_000);
    expect(second.is_closed).toBe(false);
    vi.advanceTimersByTime(3_000);
    expect(second.is_closed).toBe(true);
  });

  it('leaves alone one that opens in time', () => {
    newest().onopen?.();
    vi.advanceTimersByTime(60_000);
    expect(phases()).toEqual(['connecting', 'connected']);
  });

  it('is made anew on demand where it stalls', () => {
    newest().onopen?.();
    const stalled = newest();
    link.connectNow();
    expect(stalled.is_closed).toBe(true);
    newest().onopen?.();
    expect(phases()).toEqual(['connecting', 'connected', 'connecting', 'connected']);
  });

  it('is not made anew by itself after it gave way, only on demand', () => {
    newest().onopen?.();
    newest().onclose?.({ code: 4000, reason: 'others waited' });
    vi.advanceTimersByTime(600_000);
    expect(Socket.made).toHaveLength(1);
    expect(phases()).toEqual(['connecting', 'connected', 'gave_way']);
    link.connectNow();
    expect(Socket.made).toHaveLength(2);
  });

  it('is not asked for as often by what the server refused', () => {
    for (let attempt = 0; attempt < 8; attempt++) {
      newest().onclose?.({ code: 1009, reason: '' });
      vi.advanceTimersToNextTimer();
    }
    newest().onclose?.({ code: 1009, reason: '' });
    const { length } = Socket.made;
    vi.advanceTimersByTime(5_000);
    expect(Socket.made).toHaveLength(length);
  });
});
