// Texts in the browser's storage, which may be refused, full, or changed by hand.

/** Gives the storage, or throws where the browser refuses it. */
export type OpenStorage = () => Pick<Storage, 'getItem' | 'setItem'>;

/** `changed` hears the key of each text that another page of this browser changes. */
export type WatchStorage = (changed: (key: string | null) => void) => void;

/** Nothing where nothing is kept, or where it cannot be had. */
export function storedText(open: OpenStorage, key: string): string | null {
  try {
    return open().getItem(key);
  } catch {
    return null;
  }
}

/** Whether it is kept. */
export function storeText(open: OpenStorage, key: string, text: string): boolean {
  try {
    open().setItem(key, text);
    return true;
  } catch {
    return false;
  }
}

/** Nothing where the text is not JSON. */
export function parsedJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
