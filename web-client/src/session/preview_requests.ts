// Small pictures that the server makes on demand, each for whoever asked for it.
import type { Counter } from '../protocol/counter.ts';
import type { ClientMessage } from '../protocol/messages.ts';
import type { Stream } from '../stream/stream.ts';

export type PreviewWish = Omit<Extract<ClientMessage, { type: 'preview' }>, 'type' | 'request'>;

/** Who hears it owns the picture and closes it; there is none where the server has refused it. */
export type PreviewListener = (picture: ImageBitmap | undefined) => void;

export class PreviewRequests {
  private readonly outstanding = new Map<number, PreviewListener>();

  constructor(
    private readonly stream: Stream,
    private readonly requests: Counter,
  ) {}

  /** `answered` is called later and once, or never where the connection is lost. */
  ask(wish: PreviewWish, answered: PreviewListener): void {
    const request = this.requests.next();
    this.outstanding.set(request, answered);
    this.stream.send({ type: 'preview', request, ...wish });
  }

  /** Without a picture where it could not be decoded. */
  arrived(request: number, picture: ImageBitmap | undefined): void {
    if (!this.settle(request, picture)) picture?.close();
  }

  /** Whether the refused request was one for a preview. */
  refused(request: number | undefined): boolean {
    return request !== undefined && this.settle(request, undefined);
  }

  /** What a lost connection was asked for will not come. */
  restart(): void {
    this.outstanding.clear();
  }

  private settle(request: number, picture: ImageBitmap | undefined): boolean {
    const answered = this.outstanding.get(request);
    this.outstanding.delete(request);
    answered?.(picture);
    return answered !== undefined;
  }
}
