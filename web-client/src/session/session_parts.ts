// What a session stands on: the page, and the connection.
import type { OpenStorage, WatchStorage } from '../preferences/browser_storage.ts';
import type { Stream } from '../stream/stream.ts';
import type { FromWorker } from '../stream/worker_messages.ts';
import type { PageSight } from './presence.ts';

export type SaveFile = (name: string, content: Blob) => void;

/** What the page can do for a session. */
export interface PageParts {
  readonly saveFile: SaveFile;
  readonly openStorage: OpenStorage;
  readonly watchStorage: WatchStorage;
  readonly sight: PageSight;
}

export interface SessionParts extends PageParts {
  /** Connects at once; events come later, never from inside of this call. */
  readonly openStream: (listener: (event: FromWorker) => void) => Stream;
  readonly address: () => string;
}
