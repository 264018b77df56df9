// A whole session without a server: what it sends is kept, what it is told comes from the test.
import { expect, vi } from 'vitest';
import type {
  ClientMessage,
  ServerMessage,
  SceneMessage,
  VolumesMessage,
} from '../src/protocol/messages.ts';
import { ViewerSession } from '../src/session/viewer_session.ts';
import type { FromWorker, ShownFrame } from '../src/stream/worker_messages.ts';
import { capabilities } from './capabilities.ts';

export const volumes: VolumesMessage = {
  type: 'volumes',
  volumes: [
    { id: 'head', title: 'Head', format: 'phantom', modality: 'CT' },
    { id: 'knee', title: 'Knee', format: 'phantom', modality: 'CT' },
  ],
  refused: [],
};

export const frame = (input: number, revision: number): ShownFrame => ({
  type: 'live',
  still: false,
  lossless: false,
  view: 0,
  frame: 1,
  revision,
  input,
  clock_ms: 0,
  render_us: 0,
  encode_us: 0,
  width_px: 8,
  height_px: 6,
  viewport_width_px: 8,
  viewport_height_px: 6,
  bytes: 10,
  latency_ms: 5,
});

export class Harness {
  readonly sent: ClientMessage[] = [];
  readonly frames: (() => void)[] = [];
  readonly saved: [string, Blob][] = [];
  /** What the browser keeps. */
  readonly kept = new Map<string, string>();
  /** Another page has changed what the browser keeps under a key. */
  storageChanged: (key: string) => void = () => undefined;
  page_visible = true;
  /** The page came into sight or went out of it; a pointer or a key moved. */
  seen: () => void = () => undefined;
  used: () => void = () => undefined;
  connections_wanted = 0;
  private listener: (event: FromWorker) => void = () => undefined;
  readonly session: ViewerSession;

  constructor(
    readonly address = '',
    kept: Readonly<Record<string, string>> = {},
  ) {
    for (const [key, text] of Object.entries(kept)) this.kept.set(key, text);
    vi.stubGlobal('requestAnimationFrame', (run: () => void) => this.frames.push(run));
    this.session = new ViewerSession({
      openStream: (listener) => {
        this.listener = listener;
        return {
          send: (message) => this.sent.push(message),
          connectNow: () => {
            this.connections_wanted += 1;
          },
        };
      },
      address: () => this.address,
      saveFile: (name, content) => this.saved.push([name, content]),
      watchStorage: (changed) => (this.storageChanged = changed),
      sight: {
        visible: () => this.page_visible,
        watch: (seen, used) => Object.assign(this, { seen, used }),
      },
      openStorage: () => ({
        getItem: (key) => this.kept.get(key) ?? null,
        setItem: (key, text) => void this.kept.set(key, text),
      }),
    });
  }

  emit(event: FromWorker): void {
    this.listener(event);
  }

  say(message: ServerMessage): void {
    this.emit({ kind: 'message', message });
  }

  async connect(): Promise<void> {
    this.emit({ kind: 'link', state: { phase: 'connected' } });
    this.session.commands.resize({ width_px: 800, height_px: 600 });
    this.say(capabilities);
    this.say(volumes);
    await vi.waitFor(() => expect(this.scenes().some(({ replace }) => replace)).toBe(true));
  }

  nextFrame(): void {
    for (const run of this.frames.splice(0)) run();
  }

  scenes(): SceneMessage[] {
    return this.sent.filter((message) => message.type === 'scene');
  }

  get state() {
    return this.session.store.state;
  }
}
