// Owns the connection, decodes and paints, so that the page's main thread never waits for a
// picture.
import { decodeFrame, FrameHeaderError, type FrameMessage } from '../protocol/frame_header.ts';
import type { ClientMessage, ServerMessage } from '../protocol/messages.ts';
import { FrameQueue } from './frame_queue.ts';
import { PicturePainter, pictureBlob } from './picture_painter.ts';
import { ServerLink } from './server_link.ts';
import type { FromWorker, LinkState, ToWorker } from './worker_messages.ts';

const post = (message: FromWorker, transfer: Transferable[] = []): void =>
  self.postMessage(message, { transfer });
const faultText = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

class StreamWorker {
  private readonly queue = new FrameQueue();
  private readonly painter: PicturePainter;
  private readonly link: ServerLink;
  private painting = false;

  constructor(url: string, canvas: OffscreenCanvas) {
    this.painter = new PicturePainter(canvas);
    this.link = new ServerLink(url, this);
    this.link.connect();
  }

  connectNow(): void {
    this.link.connect();
  }

  send(message: ClientMessage): void {
    this.link.send(JSON.stringify(message));
  }

  onLinkState(state: LinkState): void {
    if (state.phase === 'connected') this.queue.restart();
    post({ kind: 'link', state });
  }

  onText(text: string): void {
    try {
      post({ kind: 'message', message: JSON.parse(text) as ServerMessage });
    } catch {
      post({ kind: 'fault', text: 'the server sent text that is not JSON' });
    }
  }

  onBinary(bytes: ArrayBuffer): void {
    try {
      this.receive(decodeFrame(bytes));
    } catch (error) {
      if (!(error instanceof FrameHeaderError)) throw error;
      post({ kind: 'fault', text: error.message });
    }
  }

  private receive(message: FrameMessage): void {
    const { type, frame: request } = message.header;
    if (type === 'saved_still') {
      post({ kind: 'saved_still', request, png: pictureBlob(message) });
    } else if (type === 'preview') {
      void this.decodePreview(message);
    } else if (this.queue.offer(message)) {
      void this.paintWaiting();
    } else {
      this.send({ type: 'ack', frame: message.header.frame });
    }
  }

  private async decodePreview(message: FrameMessage): Promise<void> {
    const { frame: request } = message.header;
    try {
      const picture = await createImageBitmap(pictureBlob(message));
      post({ kind: 'preview', request, picture }, [picture]);
    } catch {
      post({ kind: 'preview', request });
    }
  }

  private async paintWaiting(): Promise<void> {
    if (this.painting) return;
    this.painting = true;
    for (let next = this.queue.take(); next; next = this.queue.take()) await this.show(next);
    this.painting = false;
  }

  /**
   * A frame that cannot be decoded is acknowledged as well, or its credit would never come back.
   */
  private async show(message: FrameMessage): Promise<void> {
    const { header } = message;
    try {
      await this.painter.paint(message);
      const latency_ms = performance.timeOrigin + performance.now() - header.clock_ms;
      post({ kind: 'shown', frame: { ...header, bytes: message.picture.byteLength, latency_ms } });
    } catch (error) {
      post({
        kind: 'fault',
        text: `frame ${header.frame} could not be decoded: ${faultText(error)}`,
      });
    }
    this.send({ type: 'ack', frame: header.frame });
  }
}

let worker: StreamWorker | undefined;

self.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === 'start') worker = new StreamWorker(data.url, data.canvas);
  else if (data.kind === 'send') worker?.send(data.message);
  else worker?.connectNow();
};
