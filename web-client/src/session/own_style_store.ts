// Where the browser keeps the user's own styles.
import { isObject } from '../state/merge_patch.ts';
import { ownStyle, type OwnStyle } from '../state/own_styles.ts';

/** Gives the browser's storage, or throws where the browser refuses it. */
export type OpenStorage = () => Pick<Storage, 'getItem' | 'setItem'>;

const KEY = 'cutaway.styles';
/** What cannot be read is kept there, so that saving anew does not destroy it. */
const UNREADABLE_KEY = 'cutaway.styles.unreadable';
const VERSION = 1;

export class OwnStyleStore {
  constructor(private readonly open: OpenStorage) {}

  /** Nothing where what is kept there cannot be read: it is of another version, or damaged. */
  load(): readonly OwnStyle[] | undefined {
    const text = this.read();
    if (text === null) return [];
    const styles = stylesFrom(text);
    if (!styles) this.write(UNREADABLE_KEY, text);
    return styles;
  }

  /** Whether they are kept. */
  save(styles: readonly OwnStyle[]): boolean {
    return this.write(KEY, JSON.stringify({ version: VERSION, styles }));
  }

  private read(): string | null {
    try {
      return this.open().getItem(KEY);
    } catch {
      return null;
    }
  }

  /** The storage may be full, or forbidden. */
  private write(key: string, text: string): boolean {
    try {
      this.open().setItem(key, text);
      return true;
    } catch {
      return false;
    }
  }
}

function stylesFrom(text: string): readonly OwnStyle[] | undefined {
  let document: unknown;
  try {
    document = JSON.parse(text);
  } catch {
    return undefined;
  }
  if (!isObject(document) || document['version'] !== VERSION) return undefined;
  const list: unknown = document['styles'];
  if (!Array.isArray(list)) return undefined;
  const styles = list.map((one: unknown) => {
    if (!isObject(one) || typeof one['title'] !== 'string' || !isObject(one['scene']))
      return undefined;
    return ownStyle(one['title'], one['scene']);
  });
  return styles.every((style) => style !== undefined) ? styles : undefined;
}
