// What a user can do with own styles. They live in the browser's storage; several pages share it,
// so each change begins with what is there.
import {
  asStyle,
  cleanTitle,
  freeTitle,
  ownStyle,
  retitled,
  withoutStyle,
  withStyle,
  type OwnStyle,
} from '../state/own_styles.ts';
import { fileName } from '../state/file_name.ts';
import { errorDetail } from '../state/error_text.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import {
  LARGEST_FILE_BYTES,
  StyleFileError,
  styleFileText,
  styleFromFile,
} from '../state/style_file.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { ErrorMessage } from '../protocol/messages.ts';
import { words } from '../words/words.ts';
import type { OpenStorage } from '../preferences/browser_storage.ts';
import { OwnStyleStore } from './own_style_store.ts';
import type { Commands } from './commands.ts';
import type { Toasts } from './toasts.ts';
import type { SaveFile } from './session_parts.ts';

/** A file that the page can read: the browser's own kind, and what a test has. */
export type ReadableFile = Pick<File, 'name' | 'size' | 'text'>;

export class OwnStyling {
  private readonly kept: OwnStyleStore;
  /** Until the storage has refused to keep them; then they live in the page alone. */
  private works = true;
  /** The last file's style, by the input that puts it on: the server may yet refuse it. */
  private imported: { readonly input: number; readonly title: string } | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly commands: Commands,
    private readonly toasts: Toasts,
    private readonly browser: { readonly openStorage: OpenStorage; readonly saveFile: SaveFile },
  ) {
    this.kept = new OwnStyleStore(browser.openStorage);
  }

  /** Those of the visit before. Says so where they cannot be read. */
  restore(): void {
    const own_styles = this.kept.load();
    this.store.update({ own_styles: own_styles ?? [] });
    const { unreadable, unreadable_detail } = words().own_styles;
    if (!own_styles) this.toasts.problem(unreadable, unreadable_detail);
  }

  /** The present look; in place of the one that has this title already. */
  save(title: string): void {
    const { scene } = this.store.state;
    const clean = cleanTitle(title);
    if (!scene || !clean) return;
    const style = ownStyle(clean, scene as JsonObject);
    this.change((styles) => withStyle(styles, style));
    this.store.update({ base_style: asStyle(style) });
  }

  rename(title: string, wanted: string): void {
    this.change((styles) => retitled(styles, title, wanted));
  }

  remove(title: string): void {
    this.change((styles) => withoutStyle(styles, title));
  }

  /** Returns the number of the input that does. */
  apply(style: OwnStyle): number | undefined {
    return this.commands.applyStyle(asStyle(style));
  }

  exportFile(style: OwnStyle): void {
    const content = new Blob([styleFileText(style)], { type: 'application/json' });
    this.browser.saveFile(fileName(style.title, 'scene.json'), content);
  }

  /** Puts the look on, so that the server reads all of it, and keeps it. */
  async importFile(file: ReadableFile): Promise<void> {
    try {
      const style = await this.read(file);
      this.change((styles) => withStyle(styles, style));
      const input = this.apply(style);
      this.imported = input === undefined ? undefined : { input, title: style.title };
    } catch (error) {
      if (!(error instanceof StyleFileError)) throw error;
      this.toasts.problem(words().own_styles.file_refused(file.name), error.message);
    }
  }

  /** Whether the error answers a style from a file; if so that is not kept. */
  refused(error: ErrorMessage): boolean {
    const { imported } = this;
    if (!imported || error.input !== imported.input) return false;
    this.imported = undefined;
    this.remove(imported.title);
    this.toasts.problem(words().own_styles.file_refused(imported.title), errorDetail(error));
    return true;
  }

  private async read(file: ReadableFile): Promise<OwnStyle> {
    if (file.size > LARGEST_FILE_BYTES)
      throw new StyleFileError(words().own_styles.too_large(file.size, LARGEST_FILE_BYTES));
    const style = styleFromFile(await file.text(), file.name);
    return { ...style, title: freeTitle(style.title, this.store.state.own_styles) };
  }

  private change(change: (styles: readonly OwnStyle[]) => readonly OwnStyle[]): void {
    const before = this.works ? (this.kept.load() ?? []) : this.store.state.own_styles;
    const own_styles = change(before);
    this.store.update({ own_styles });
    if (!this.works) return;
    this.works = this.kept.save(own_styles);
    if (!this.works)
      this.toasts.problem(words().own_styles.not_kept, words().own_styles.not_kept_detail);
  }
}
