// The page's end of the stream worker.
import type { ClientMessage } from '../protocol/messages.ts';
import type { FromWorker, ToWorker } from './worker_messages.ts';

export interface Stream {
  send(message: ClientMessage): void;
  connectNow(): void;
}

export class WorkerStream implements Stream {
  private readonly worker = new Worker(new URL('./stream_worker.ts', import.meta.url), {
    type: 'module',
  });

  /**
   * Starts to connect at once; pictures appear on the canvas of their view, by number, and everything
   * else comes to `listener`.
   */
  constructor(
    canvases: readonly HTMLCanvasElement[],
    url: string,
    listener: (event: FromWorker) => void,
  ) {
    this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => listener(data);
    this.worker.onerror = (event) => listener({ kind: 'fault', text: event.message });
    const offscreen = canvases.map((canvas) => canvas.transferControlToOffscreen());
    this.post({ kind: 'start', url, canvases: offscreen }, offscreen);
  }

  send(message: ClientMessage): void {
    this.post({ kind: 'send', message });
  }

  connectNow(): void {
    this.post({ kind: 'connect_now' });
  }

  private post(message: ToWorker, transfer: Transferable[] = []): void {
    this.worker.postMessage(message, transfer);
  }
}

export function webSocketUrl(location: Location): string {
  const url = new URL('ws', location.href);
  url.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  url.hash = '';
  url.search = '';
  return url.href;
}
