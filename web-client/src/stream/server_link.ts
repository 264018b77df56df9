// The WebSocket to the server, opened again whenever it is lost.
import { ReconnectBackoff } from '../protocol/reconnect_backoff.ts';
import type { LinkReason, LinkState } from './worker_messages.ts';

/** Close codes of RFC 6455 and its registry. */
const TOO_LARGE = 1009;
const TRY_AGAIN_LATER = 1013;

const SUBPROTOCOL = 'cutaway.v1';
/**
 * A session counts as working once it has lasted this long; before, the next wait is longer still.
 */
const SETTLED_MS = 2_000;

export interface LinkListener {
  onLinkState(state: LinkState): void;
  onText(text: string): void;
  onBinary(message: ArrayBuffer): void;
}

function reasonFor(close: CloseEvent, was_open: boolean): LinkReason {
  if (close.code === TOO_LARGE) return 'too_large';
  if (close.code === TRY_AGAIN_LATER) return 'full';
  return was_open ? 'lost' : 'no_answer';
}

export class ServerLink {
  private socket: WebSocket | undefined;
  private retry: ReturnType<typeof setTimeout> | undefined;
  private opened_at_ms: number | undefined;
  private readonly backoff = new ReconnectBackoff();

  constructor(
    private readonly url: string,
    private readonly listener: LinkListener,
  ) {}

  connect(): void {
    if (this.socket) return;
    clearTimeout(this.retry);
    this.listener.onLinkState({ phase: 'connecting' });
    const socket = new WebSocket(this.url, SUBPROTOCOL);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.opened();
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.received(event.data);
    socket.onclose = (event) => this.closed(event);
    this.socket = socket;
  }

  /**
   * A message while there is no connection is dropped: the whole view is sent when there is one
   * again.
   */
  send(text: string): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(text);
  }

  private opened(): void {
    this.opened_at_ms = performance.now();
    this.listener.onLinkState({ phase: 'connected' });
  }

  private received(data: string | ArrayBuffer): void {
    if (typeof data === 'string') this.listener.onText(data);
    else this.listener.onBinary(data);
  }

  private closed(event: CloseEvent): void {
    const was_open = this.opened_at_ms !== undefined;
    if (was_open && performance.now() - (this.opened_at_ms ?? 0) > SETTLED_MS) this.backoff.reset();
    this.socket = undefined;
    this.opened_at_ms = undefined;
    const reason = reasonFor(event, was_open);
    const retry_in_ms = this.backoff.nextDelayMs(reason === 'full');
    this.listener.onLinkState({
      phase: 'waiting',
      retry_in_ms,
      reason,
      said: event.reason,
    });
    this.retry = setTimeout(() => this.connect(), retry_in_ms);
  }
}
