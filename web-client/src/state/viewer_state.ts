// All that the page shows, in one place.
import { isAfter } from '../protocol/counter.ts';
import type {
  CapabilitiesMessage,
  LoadingMessage,
  RefusedEntry,
  Scene,
  Style,
  UnseenReason,
  VolumeEntry,
  VolumeSummary,
} from '../protocol/messages.ts';
import { NOTHING_EXPORTED, type ExportState } from './export_state.ts';
import { NOTHING_MEASURED, type MeasureState } from './measure_state.ts';
import type { OwnStyle } from './own_styles.ts';
import type { SliceHover, Tilting } from './slice_pointing.ts';
import { NO_SLICES, type SliceViews } from './slice_views.ts';
import type { ViewName } from './views.ts';
import type { LinkState, ShownFrame } from '../stream/worker_messages.ts';
import type { Viewport } from '../view/camera.ts';
import { DEFAULT_PREFERENCES, type Preferences } from '../preferences/preferences.ts';
import type { Language } from '../words/language.ts';

export interface ToastAction {
  readonly label: string;
  readonly run: () => void;
}

export interface Toast {
  readonly id: number;
  readonly tone: 'problem' | 'note';
  readonly title: string;
  readonly detail: string;
  /** What can be done about it. */
  readonly action?: ToastAction;
}

export type PanelTab = 'volumes' | 'styles' | 'adjust' | 'measure' | 'view';

export interface ViewerState {
  readonly link: LinkState;
  /** Names in them, and in the volumes, are in the page's language. */
  readonly capabilities: CapabilitiesMessage | undefined;
  readonly volumes: readonly VolumeEntry[];
  readonly refused: readonly RefusedEntry[];
  /** The server still looks through its data folders. */
  readonly scanning: boolean;
  /** A volume is to be opened once one of a file is there, or none will come. */
  readonly awaits_volume: boolean;
  readonly loading: LoadingMessage | undefined;
  /** What the user has set; ahead of the picture. */
  readonly scene: Scene | undefined;
  readonly can_undo: boolean;
  readonly can_redo: boolean;
  /** The previous look is shown, for as long as a key or a button is held. */
  readonly comparing: boolean;
  /** The style, the server's or an own one, that was put on last, or that the scene came with. */
  readonly base_style: Style | undefined;
  readonly volume: VolumeSummary | undefined;
  /** Of the 3-D picture; those of the slices are theirs. */
  readonly viewport: Viewport | undefined;
  readonly slice_views: SliceViews;
  /** Has the page for itself for a while. */
  readonly maximised: ViewName | undefined;
  /** Under the pointer in a slice. */
  readonly slice_hover: SliceHover | undefined;
  /** A drag in a slice changes the window, and does not move the crosshair. */
  readonly drags_window: boolean;
  readonly tilting: Tilting | undefined;
  /** Where the crosshair goes, the lens goes. */
  readonly lens_at_crosshair: boolean;
  /** Number of the last input that the 3-D picture is to show. */
  readonly sent_input: number;
  /** Number of the last input that it does show, as far as is known. */
  readonly shown_input: number;
  readonly shown: ShownFrame | undefined;
  /** What the picture shows; behind `scene` by its latency. */
  readonly shown_scene: Scene | undefined;
  /** An input has waited long for its picture. */
  readonly stalled: boolean;
  /** Why the 3-D picture shows nothing where something is expected, as the server says. */
  readonly unseen: readonly UnseenReason[];
  readonly frames_per_second: number;
  /** By volume: as it first appears, small; or that there is none to be had. */
  readonly volume_pictures: ReadonlyMap<string, ImageBitmap | 'failed'>;
  /** By style, an own one's by what it says: the scene in that style, small. */
  readonly previews: ReadonlyMap<string, ImageBitmap>;
  /** A button is held or a finger is down. */
  readonly pointer_held: boolean;
  /** The lens goes where the pointer is. */
  readonly lens_follows: boolean;
  readonly measure: MeasureState;
  readonly own_styles: readonly OwnStyle[];
  readonly exporting: ExportState;
  /** Whether the page's address holds `scene`. */
  readonly address_current: boolean;
  readonly toasts: readonly Toast[];
  readonly preferences: Preferences;
  /** What the page speaks; behind the preference while a catalogue is loaded. */
  readonly language: Language;
  readonly panel_tab: PanelTab;
  readonly help_open: boolean;
}

export const INITIAL_STATE: ViewerState = {
  link: { phase: 'connecting' },
  capabilities: undefined,
  volumes: [],
  refused: [],
  scanning: false,
  awaits_volume: false,
  loading: undefined,
  scene: undefined,
  can_undo: false,
  can_redo: false,
  comparing: false,
  base_style: undefined,
  volume: undefined,
  viewport: undefined,
  slice_views: NO_SLICES,
  maximised: undefined,
  slice_hover: undefined,
  drags_window: false,
  tilting: undefined,
  lens_at_crosshair: false,
  sent_input: 0,
  shown_input: 0,
  shown: undefined,
  shown_scene: undefined,
  stalled: false,
  unseen: [],
  frames_per_second: 0,
  volume_pictures: new Map(),
  previews: new Map(),
  pointer_held: false,
  lens_follows: false,
  measure: NOTHING_MEASURED,
  own_styles: [],
  exporting: NOTHING_EXPORTED,
  address_current: false,
  toasts: [],
  preferences: DEFAULT_PREFERENCES,
  language: 'en',
  panel_tab: 'styles',
  help_open: false,
};

/** An input went out that the 3-D picture does not show yet. */
export const awaitsPicture = ({ sent_input, shown_input }: ViewerState): boolean =>
  isAfter(sent_input, shown_input);
