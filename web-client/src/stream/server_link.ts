// The WebSocket to the server, opened again whenever it is lost.
import { ReconnectBackoff } from '../protocol/reconnect_backoff.ts';
import type { LinkLoss, LinkReason, LinkState } from './worker_messages.ts';

/** Close codes of RFC 6455 and its registry. */
const TOO_LARGE = 1009;
const TRY_AGAIN_LATER = 1013;
const NO_CODE = 1006;
/** Of the protocol's own: the session went to another who waited. */
const GAVE_WAY = 4000;

const SUBPROTOCOL = 'cutaway.v1';
/**
 * A session counts as working once it has lasted this long; before, the next wait is longer still.
 */
const SETTLED_MS = 2_000;
/** An attempt that hangs, as behind a dead route, is given up for the next; that may take longer. */
const ATTEMPT_MS = 3_000;
const LONGEST_ATTEMPT_MS = 12_000;

export interface LinkListener {
  onLinkState(state: LinkState): void;
  onText(text: string): void;
  onBinary(message: ArrayBuffer): void;
}

function reasonFor(code: number, was_open: boolean): LinkReason {
  if (code === TOO_LARGE) return 'too_large';
  if (code === TRY_AGAIN_LATER) return 'full';
  return was_open ? 'lost' : 'no_answer';
}

export class ServerLink {
  private socket: WebSocket | undefined;
  private retry: ReturnType<typeof setTimeout> | undefined;
  private opened_at_ms: number | undefined;
  private attempt: ReturnType<typeof setTimeout> | undefined;
  private attempt_ms = ATTEMPT_MS;
  private loss: LinkLoss | undefined;
  private readonly backoff = new ReconnectBackoff();

  constructor(
    private readonly url: string,
    private readonly listener: LinkListener,
  ) {}

  connect(): void {
    if (this.socket) return;
    clearTimeout(this.retry);
    this.listener.onLinkState({ phase: 'connecting', ...this.loss });
    const socket = new WebSocket(this.url, SUBPROTOCOL);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.opened();
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.received(event.data);
    socket.onclose = (event) => this.closed(event.code, event.reason);
    this.socket = socket;
    this.attempt = setTimeout(() => this.giveUp(), this.attempt_ms);
  }

  /** Also instead of a connection that stalls, or an attempt that hangs. */
  connectNow(): void {
    this.drop();
    this.connect();
  }

  /**
   * A message while there is no connection is dropped: the whole view is sent when there is one
   * again.
   */
  send(text: string): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(text);
  }

  private giveUp(): void {
    this.attempt_ms = Math.min(LONGEST_ATTEMPT_MS, 2 * this.attempt_ms);
    this.drop();
    this.closed(NO_CODE, '');
  }

  /** Without a word of it from the socket later. */
  private drop(): void {
    clearTimeout(this.attempt);
    const { socket } = this;
    if (!socket) return;
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
    this.socket = undefined;
  }

  private opened(): void {
    clearTimeout(this.attempt);
    this.attempt_ms = ATTEMPT_MS;
    this.loss = undefined;
    this.opened_at_ms = performance.now();
    this.listener.onLinkState({ phase: 'connected' });
  }

  private received(data: string | ArrayBuffer): void {
    if (typeof data === 'string') this.listener.onText(data);
    else this.listener.onBinary(data);
  }

  private closed(code: number, said: string): void {
    clearTimeout(this.attempt);
    const was_open = this.opened_at_ms !== undefined;
    if (was_open && performance.now() - (this.opened_at_ms ?? 0) > SETTLED_MS) this.backoff.reset();
    this.socket = undefined;
    this.opened_at_ms = undefined;
    if (code === GAVE_WAY) {
      this.loss = undefined;
      return this.listener.onLinkState({ phase: 'gave_way' });
    }
    const reason = reasonFor(code, was_open);
    this.loss = { reason, said };
    const retry_in_ms = this.backoff.nextDelayMs(reason === 'full' || reason === 'too_large');
    this.listener.onLinkState({ phase: 'waiting', retry_in_ms, ...this.loss });
    this.retry = setTimeout(() => this.connect(), retry_in_ms);
  }
}
