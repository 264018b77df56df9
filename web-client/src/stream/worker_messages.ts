// What the page and its stream worker say to each other.
import type { FrameHeader } from '../protocol/frame_header.ts';
import type { ClientMessage, ServerMessage } from '../protocol/messages.ts';

export type ToWorker =
  /** The canvases are those of the views, by number. */
  | { readonly kind: 'start'; readonly url: string; readonly canvases: readonly OffscreenCanvas[] }
  | { readonly kind: 'send'; readonly message: ClientMessage }
  /** Do not wait for the next attempt to connect. */
  | { readonly kind: 'connect_now' };

export interface ShownFrame extends FrameHeader {
  readonly bytes: number;
  /** On the page's clock, from the input that the picture shows to its painting. */
  readonly latency_ms: number;
}

export type LinkState =
  /** Why there is no connection yet; nothing at the first attempt. */
  | ({ readonly phase: 'connecting' } & Partial<LinkLoss>)
  | { readonly phase: 'connected' }
  /** The server is full; `place` 1 is the next to be let in. */
  | { readonly phase: 'queued'; readonly place: number }
  /** The session went to another who waited; nothing is tried until the user comes back. */
  | { readonly phase: 'gave_way' }
  | ({ readonly phase: 'waiting'; readonly retry_in_ms: number } & LinkLoss);

export interface LinkLoss {
  readonly reason: LinkReason;
  /** The server's own words; often none. */
  readonly said: string;
}

export type LinkReason = 'lost' | 'no_answer' | 'too_large' | 'full';

export type FromWorker =
  | { readonly kind: 'link'; readonly state: LinkState }
  | { readonly kind: 'message'; readonly message: ServerMessage }
  | { readonly kind: 'shown'; readonly frame: ShownFrame }
  | { readonly kind: 'saved_still'; readonly request: number; readonly png: Blob }
  /** Without a picture where it could not be decoded. Who takes the picture also closes it. */
  | { readonly kind: 'preview'; readonly request: number; readonly picture?: ImageBitmap }
  /** Something came that is no part of the protocol, or could not be decoded. */
  | { readonly kind: 'fault'; readonly text: string };
