// Pictures and films as files. One is made at a time, and it can be given up; the session's own
// scene stays the user's meanwhile.
import { pathFilm } from '../film/camera_path.ts';
import type { Film, FilmFrame } from '../film/film.ts';
import { filmFile, labeller, type FormatSupport } from '../film/film_file.ts';
import type { Labelling } from '../film/labelled_pictures.ts';
import { pipelined } from '../film/pipeline.ts';
import { withNotes } from '../film/png_notes.ts';
import { wholeScene } from '../film/whole_scene.ts';
import { turntableFilm, type Turntable } from '../film/turntable.ts';
import type { Scene } from '../protocol/messages.ts';
import type { ExportJob, ExportState } from '../state/export_state.ts';
import { fileName } from '../state/file_name.ts';
import { viewCamera } from '../state/scene_parts.ts';
import { viewChoice } from '../state/slice_views.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import { chiefView, viewNumber, type ViewName } from '../state/views.ts';
import type { Viewport } from '../view/camera.ts';
import { words } from '../words/words.ts';
import { PathRecorder } from './path_recorder.ts';
import { ExportError, STILLS_IN_FLIGHT, type Stills } from './stills.ts';
import type { Toasts } from './toasts.ts';
import type { SaveFile } from './session_parts.ts';

export interface FilmWish {
  readonly motion: Turntable | 'path';
  readonly frames_per_second: number;
  readonly size: Viewport;
  readonly format: FormatSupport;
}

interface ExportedFile {
  readonly name: string;
  readonly content: Blob;
}

export class Exporting {
  readonly recorder: PathRecorder;
  private current: AbortController | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly stills: Stills,
    private readonly toasts: Toasts,
    private readonly saveFile: SaveFile,
  ) {
    this.recorder = new PathRecorder(store);
    store.subscribe((state, before) => {
      if (state.volume?.id === before.volume?.id) return;
      const { other_volume, other_volume_detail } = words().export;
      this.current?.abort(new ExportError(other_volume, other_volume_detail));
    });
  }

  /** For a picture of that view. */
  open(view = chiefView(viewChoice(this.store.state))): void {
    this.update({ view });
    this.show(true);
  }

  chooseView(view: ViewName): void {
    this.update({ view });
  }

  /** Ends a recording, where there is one. What was said of the last file goes with the dialog. */
  show(open: boolean): void {
    const { recording_since_ms } = this.store.state.exporting;
    if (open && recording_since_ms !== undefined) this.recorder.stop();
    else this.update({ open, ...(!open && { outcome: undefined }) });
  }

  /** Of the view as it is now; it is one of those that are open. */
  async savePicture(view: ViewName, size: Viewport, dots_per_inch?: number): Promise<void> {
    const notes = {
      disclaimer: this.notice,
      ...(dots_per_inch !== undefined && { dots_per_inch }),
    };
    const name = this.fileName('png', view);
    const still = view === '3d' ? size : { ...size, view: viewNumber(view) };
    const labelling = this.labelling(view, size);
    const scene = this.store.state.scene ?? {};
    await this.run({ what: 'picture', frames: 1 }, async (signal) => {
      const png = await this.stills.make(still, signal, wholeScene(scene));
      const picture = labelling ? await (await labeller(labelling))({ png, scene }) : png;
      return { name, content: await withNotes(picture, notes) };
    });
  }

  async saveFilm(wish: FilmWish): Promise<void> {
    const film = this.filmOf(wish);
    const { format, size } = wish;
    if (!film || 'missing' in format) return;
    const name = this.fileName(format.format);
    const { frames, frames_per_second } = film;
    const labelling = this.labelling('3d', size);
    const settings = {
      size,
      frames_per_second,
      notice: this.notice,
      ...(labelling && { labelling }),
    };
    await this.run({ what: 'film', frames }, async (signal) => {
      const pictures = this.pictures(film, size, signal);
      return { name, content: await filmFile(pictures, format, settings) };
    });
  }

  cancel(): void {
    this.current?.abort();
  }

  /** The server is waited for: it has refused something for now, or there is no connection. */
  lags(lags: boolean): void {
    if (this.store.state.exporting.lags !== lags) this.update({ lags });
  }

  private filmOf({ motion, frames_per_second }: FilmWish): Film | undefined {
    const { scene, exporting } = this.store.state;
    if (motion === 'path') return exporting.path && pathFilm(exporting.path, frames_per_second);
    const camera = viewCamera(this.store.state);
    return scene && camera && turntableFilm(scene, camera, motion, frames_per_second);
  }

  private async *pictures(
    { frames, sceneOf }: Film,
    size: Viewport,
    signal: AbortSignal,
  ): AsyncGenerator<FilmFrame> {
    const make = (index: number): Promise<Blob> =>
      this.stills.make({ ...size, scene: sceneOf(index) }, signal);
    let frames_done = 0;
    for await (const png of pipelined(frames, STILLS_IN_FLIGHT, make)) {
      const scene = sceneOf(frames_done) as Scene;
      frames_done += 1;
      this.progress(frames_done);
      yield { png, scene };
    }
  }

  /** Aborts what is left of it at its end, whatever that was. */
  private async run(
    job: Pick<ExportJob, 'what' | 'frames'>,
    make: (signal: AbortSignal) => Promise<ExportedFile>,
  ): Promise<void> {
    if (this.current) return;
    const current = new AbortController();
    this.current = current;
    const began = { ...job, frames_done: 0, began_ms: performance.now() };
    this.update({ job: began, outcome: undefined });
    try {
      const { name, content } = await make(current.signal);
      current.signal.throwIfAborted();
      this.saved(name, content);
    } catch (error) {
      const given_up = current.signal.aborted && !(error instanceof ExportError);
      if (!given_up) this.failed(error);
    } finally {
      current.abort();
      this.current = undefined;
      this.update({ job: undefined });
    }
  }

  private progress(frames_done: number): void {
    const { job } = this.store.state.exporting;
    if (job) this.update({ job: { ...job, frames_done } });
  }

  private saved(name: string, content: Blob): void {
    this.saveFile(name, content);
    this.update({ outcome: { kind: 'saved', name, bytes: content.size } });
    if (!this.store.state.exporting.open) this.toasts.note(words().export.saved(name));
  }

  /** Without the dialog, which else says it, a message does. */
  private failed(error: unknown): void {
    const unexpected = error instanceof Error ? error.message : String(error);
    const { title, detail } =
      error instanceof ExportError ? error : { title: words().export.failed, detail: unexpected };
    this.update({ outcome: { kind: 'failed', title, detail } });
    if (!this.store.state.exporting.open) this.toasts.problem(title, detail);
  }

  /** Nothing where the user wants the pictures bare. */
  private labelling(view: ViewName, size: Viewport): Labelling | undefined {
    const { volume, preferences } = this.store.state;
    if (!volume || !preferences.picture_labels) return undefined;
    const subject = { volume, view, size, notice: this.notice };
    const { labels_left_out, labels_left_out_detail } = words().export;
    const refused = (): void => this.toasts.problem(labels_left_out, labels_left_out_detail);
    return { subject, refused };
  }

  private get notice(): string {
    return this.store.state.capabilities?.notice ?? words().page.not_for_diagnosis;
  }

  private fileName(extension: string, view: ViewName = '3d'): string {
    const title = this.store.state.volume?.title ?? words().messages.picture;
    const slice = view === '3d' ? '' : ` ${words().slices.names[view].toLowerCase()}`;
    return fileName(`cutaway ${title}${slice}`, extension);
  }

  private update(change: Partial<ExportState>): void {
    this.store.update({ exporting: { ...this.store.state.exporting, ...change } });
  }
}
