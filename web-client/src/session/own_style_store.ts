// Where the browser keeps the user's own styles.
import {
  parsedJson,
  storedText,
  storeText,
  type OpenStorage,
} from '../preferences/browser_storage.ts';
import { isObject } from '../state/merge_patch.ts';
import { ownStyle, type OwnStyle } from '../state/own_styles.ts';

const KEY = 'cutaway.styles';
/** What cannot be read is kept there, so that saving anew does not destroy it. */
const UNREADABLE_KEY = 'cutaway.styles.unreadable';
const VERSION = 1;

export class OwnStyleStore {
  constructor(private readonly open: OpenStorage) {}

  /** Nothing where what is kept there cannot be read: it is of another version, or damaged. */
  load(): readonly OwnStyle[] | undefined {
    const text = storedText(this.open, KEY);
    if (text === null) return [];
    const styles = stylesFrom(text);
    if (!styles) storeText(this.open, UNREADABLE_KEY, text);
    return styles;
  }

  /** Whether they are kept. */
  save(styles: readonly OwnStyle[]): boolean {
    return storeText(this.open, KEY, JSON.stringify({ version: VERSION, styles }));
  }
}

function stylesFrom(text: string): readonly OwnStyle[] | undefined {
  const document = parsedJson(text);
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
