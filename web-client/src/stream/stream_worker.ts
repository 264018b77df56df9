// Owns the connection, decodes and paints, so that the page's main thread never waits for a
// picture.
import { decodeFrame, FrameHeaderError, type FrameMessage } from '../protocol/frame_header.ts';
import type { ClientMessage, ServerMessage } from '../protocol/messages.ts';
import { pictureBlob } from './picture_painter.ts';
import { ServerLink } from './server_link.ts';
import { ViewStream, type FrameListener } from './view_stream.ts';
import type { FromWorker, LinkState, ToWorker } from './worker_messages.ts';

const post = (message: FromWorker, transfer: Transferable[] = []): void =>
  self.postMessage(message, { transfer });
const faultText = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

class StreamWorker implements FrameListener {
  private readonly views: readonly ViewStream[];
  private readonly link: ServerLink;

  /** The canvases are those of the views, by number. */
  constructor(url: string, canvases: readonly OffscreenCanvas[]) {
    this.views = canvases.map((canvas) => new ViewStream(canvas, this));
    this.link = new ServerLink(url, this);
    this.link.connect();
  }

  connectNow(): void {
    this.link.connectNow();
  }

  send(message: ClientMessage): void {
    this.link.send(JSON.stringify(message));
  }

  onLinkState(state: LinkState): void {
    if (state.phase === 'connected') for (const view of this.views) view.restart();
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
    const { type, view, frame: request } = message.header;
    if (type === 'saved_still') {
      post({ kind: 'saved_still', request, png: pictureBlob(message) });
    } else if (type === 'preview') {
      void this.decodePreview(message);
    } else {
      this.views[view]?.received(message);
    }
  }

  done({ header: { view, frame } }: FrameMessage): void {
    this.send({ type: 'ack', view, frame });
  }

  painted({ header, picture }: FrameMessage): void {
    const latency_ms = performance.timeOrigin + performance.now() - header.clock_ms;
    post({ kind: 'shown', frame: { ...header, bytes: picture.byteLength, latency_ms } });
  }

  failed({ header: { frame } }: FrameMessage, error: unknown): void {
    post({ kind: 'fault', text: `frame ${frame} could not be decoded: ${faultText(error)}` });
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
}

let worker: StreamWorker | undefined;

self.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === 'start') worker = new StreamWorker(data.url, data.canvases);
  else if (data.kind === 'send') worker?.send(data.message);
  else worker?.connectNow();
};
