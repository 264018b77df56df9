// Brings the stream's events into the state.
import { errorDetail, errorTitle } from '../state/error_text.ts';
import { Store } from '../state/store.ts';
import { asStyle } from '../state/own_styles.ts';
import { matchingStyle } from '../state/style_patch.ts';
import { INITIAL_STATE, type ViewerState } from '../state/viewer_state.ts';
import { VIEW_NAMES } from '../state/views.ts';
import { Counter } from '../protocol/counter.ts';
import type {
  CapabilitiesMessage,
  ErrorMessage,
  LoadingMessage,
  ServerMessage,
  VolumeEntry,
  VolumeSummary,
} from '../protocol/messages.ts';
import { WorkerStream } from '../stream/stream.ts';
import type { FromWorker, LinkState, ShownFrame } from '../stream/worker_messages.ts';
import { Commands } from './commands.ts';
import { Exporting } from './exporting.ts';
import { FrameRate } from './frame_rate.ts';
import { Measured } from './measured.ts';
import { Measuring } from './measuring.ts';
import { OwnStyling } from './own_styling.ts';
import { Picker } from './picker.ts';
import { Presence } from './presence.ts';
import { PreviewRequests } from './preview_requests.ts';
import { Resending } from './resending.ts';
import { SceneLink } from './scene_link.ts';
import { SceneOpening } from './scene_opening.ts';
import type { PageParts, SessionParts } from './session_parts.ts';
import { watchForStalls } from './stall_watch.ts';
import { Slicing } from './slicing.ts';
import { Stills } from './stills.ts';
import { ViewportFit } from './viewport_fit.ts';
import { VolumePictures } from './volume_pictures.ts';
import { StylePreviews } from './style_previews.ts';
import { Toasts } from './toasts.ts';
import { ViewLayout } from './view_layout.ts';
import type { Language } from '../words/language.ts';
import { capabilitiesInWords, volumeInWords } from '../words/served.ts';
import { words } from '../words/words.ts';

const LAST_STAGES: ReadonlySet<LoadingMessage['stage']> = new Set(['ready', 'cancelled', 'failed']);

interface Told {
  capabilities: CapabilitiesMessage | undefined;
  volumes: readonly VolumeEntry[];
  volume: VolumeSummary | undefined;
}

export class ViewerSession {
  readonly store = new Store<ViewerState>(INITIAL_STATE);
  readonly toasts = new Toasts(this.store);
  readonly viewport_fit = new ViewportFit(this.store, this.toasts);
  readonly commands: Commands;
  readonly layout: ViewLayout;
  readonly slicing: Slicing;
  readonly previews: StylePreviews;
  readonly volume_pictures: VolumePictures;
  readonly measured: Measured;
  readonly measuring: Measuring;
  readonly own_styling: OwnStyling;
  readonly exporting: Exporting;
  private readonly stills: Stills;
  private readonly preview_requests: PreviewRequests;
  private readonly picker: Picker;
  private readonly link: SceneLink;
  private readonly opening: SceneOpening;
  private readonly presence: Presence;
  private readonly resending: Resending;
  /** As it came. */
  private readonly told: Told = { capabilities: undefined, volumes: [], volume: undefined };
  private readonly frame_rate = new FrameRate();

  constructor(private readonly parts: SessionParts) {
    const stream = parts.openStream((event) => this.onEvent(event));
    this.link = new SceneLink(this.store, stream);
    this.opening = new SceneOpening(this.store, this.link, this.toasts);
    this.presence = new Presence(this.store, stream, parts.sight);
    const requests = new Counter();
    this.commands = new Commands(this.store, this.link, stream, this.toasts);
    this.picker = new Picker(stream, requests, () => this.link.flush());
    this.layout = new ViewLayout(this.store, this.link, this.commands);
    this.slicing = new Slicing(this.store, this.commands, this.picker, this.toasts);
    this.measured = new Measured(this.store, this.commands, this.toasts, parts);
    this.measuring = new Measuring(
      this.store,
      this.picker,
      this.toasts,
      this.measured,
      this.commands,
    );
    this.own_styling = new OwnStyling(this.store, this.commands, this.toasts, parts);
    this.stills = new Stills(stream, requests, this.link, (lags) => this.exporting.lags(lags));
    this.exporting = new Exporting(this.store, this.stills, this.toasts, parts.saveFile);
    this.preview_requests = new PreviewRequests(stream, requests);
    this.previews = new StylePreviews(this.store, this.preview_requests);
    this.volume_pictures = new VolumePictures(this.store, this.preview_requests);
    const { presence, link, layout, picker } = this;
    this.resending = new Resending(this.store, { presence, link, layout, picker });
    watchForStalls(this.store);
  }

  /** The user has put another link into the address. */
  async openAddress(): Promise<void> {
    await this.opening.openAddress(this.parts.address());
  }

  /** The page speaks another language from now on. */
  spoken(language: Language): void {
    this.publish();
    this.store.update({ language });
  }

  /** Names that came with what the server told, in the page's language. */
  private publish(): void {
    const { capabilities, volumes, volume } = this.told;
    const { served } = words();
    this.store.update({
      capabilities: capabilities && capabilitiesInWords(capabilities, served),
      volumes: volumes.map((entry) => volumeInWords(entry, served)),
      volume: volume && volumeInWords(volume, served),
    });
  }

  private onEvent(event: FromWorker): void {
    switch (event.kind) {
      case 'link':
        return this.onLink(event.state);
      case 'message':
        return this.onMessage(event.message);
      case 'shown':
        return this.onShown(event.frame);
      case 'saved_still':
        return this.stills.arrived(event.request, event.png);
      case 'preview':
        return this.preview_requests.arrived(event.request, event.picture);
      case 'fault':
        return this.toasts.problem(words().messages.unexpected, event.text);
    }
  }

  private onLink(link: LinkState): void {
    this.preview_requests.restart();
    this.previews.restart();
    this.volume_pictures.restart();
    this.picker.restart();
    this.stills.interrupted();
    this.resending.restart();
    this.store.update({ link, unseen: [] });
    if (link.phase !== 'connected') return;
    this.told.capabilities = undefined;
    this.store.update({ loading: undefined, capabilities: undefined });
  }

  /** The server heeds nothing that comes before its capabilities went out. */
  private onCapabilities(capabilities: CapabilitiesMessage): void {
    this.told.capabilities = capabilities;
    this.publish();
    this.store.update({ link: { phase: 'connected' } });
    this.presence.restart();
    this.link.restart();
    this.opening.restart();
    this.layout.restart();
  }

  private onMessage(message: ServerMessage): void {
    switch (message.type) {
      case 'queued':
        return this.store.update({ link: { phase: 'queued', place: message.place } });
      case 'capabilities':
        return this.onCapabilities(message);
      case 'volumes': {
        const { volumes, refused, scanning = false } = message;
        this.told.volumes = volumes;
        this.publish();
        this.store.update({ refused, scanning });
        return void this.opening.begin(this.parts.address());
      }
      case 'loading':
        return this.onLoading(message);
      case 'scene': {
        this.link.told(message);
        if (!message.volume) return;
        this.opening.told();
        this.stills.served();
        this.told.volume = message.volume;
        this.publish();
        return this.findBaseStyle();
      }
      case 'error':
        return this.onError(message);
      case 'picked':
        return this.picker.arrived(message);
      case 'unseen':
        return this.store.update({ unseen: message.reasons });
    }
  }

  private findBaseStyle(): void {
    const { scene, capabilities, own_styles } = this.store.state;
    const styles = [...(capabilities?.styles ?? []), ...own_styles.map(asStyle)];
    const base_style = matchingStyle(scene, styles);
    if (base_style) this.store.update({ base_style });
  }

  private onLoading(loading: LoadingMessage): void {
    this.link.heardOfOpening();
    this.store.update({ loading: LAST_STAGES.has(loading.stage) ? undefined : loading });
    if (loading.stage === 'cancelled') this.toasts.note(words().messages.opening_cancelled);
  }

  private onError(error: ErrorMessage): void {
    if (error.code === 'gave-way') return; // the end of the connection says so, too
    this.link.refused(error);
    this.resending.refused(error);
    const answers_own = [
      this.opening.refused(error),
      this.preview_requests.refused(error.request),
      this.picker.refused(error.request),
      this.stills.refused(error),
      this.own_styling.refused(error),
    ];
    if (answers_own.includes(true)) return;
    this.toasts.problem(errorTitle(error), errorDetail(error));
  }

  private onShown(shown: ShownFrame): void {
    const view = VIEW_NAMES[shown.view];
    if (view && view !== '3d') return this.layout.shown(view, shown);
    const frames_per_second = this.frame_rate.shown(performance.now());
    this.store.update({ shown, shown_scene: this.link.shown(shown), frames_per_second });
  }
}

export function openViewerSession(
  canvases: readonly HTMLCanvasElement[],
  url: string,
  page: PageParts,
): ViewerSession {
  return new ViewerSession({
    openStream: (listener) => new WorkerStream(canvases, url, listener),
    address: () => location.hash,
    ...page,
  });
}
