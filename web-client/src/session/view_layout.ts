// Which of the session's pictures are on the page, and how large.
import type { Store } from '../state/store.ts';
import { CLOSED_VIEW, viewChoice, type SliceView } from '../state/slice_views.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import { chiefView, enlarged, nextLayout, type Layout, type ViewName } from '../state/views.ts';
import type { ShownFrame } from '../stream/worker_messages.ts';
import type { Viewport } from '../view/camera.ts';
import { SLICE_NAMES, type SliceName } from '../view/slice_geometry.ts';
import type { Commands } from './commands.ts';
import type { SceneLink } from './scene_link.ts';

export class ViewLayout {
  constructor(
    private readonly store: Store<ViewerState>,
    private readonly link: SceneLink,
    private readonly commands: Commands,
  ) {}

  /** Of the pictures on the page. */
  get chief_view(): ViewName {
    return chiefView(viewChoice(this.store.state));
  }

  /** One alone is the volume. */
  choose(layout: Layout): void {
    this.store.update({ maximised: undefined });
    this.commands.prefer(layout === 'single' ? { layout, main_view: '3d' } : { layout });
  }

  next(): void {
    this.choose(nextLayout(viewChoice(this.store.state)));
  }

  /** A small view becomes the large one, another gets the page for itself, and back. */
  enlarge(name: ViewName): void {
    const { maximised, ...preferences } = enlarged(viewChoice(this.store.state), name);
    this.store.update({ maximised });
    this.commands.prefer(preferences);
  }

  /** A slice is on the page and has that size, device pixels. */
  resize(name: SliceName, viewport: Viewport): void {
    if (!this.store.state.slice_views[name].viewport) this.link.openSlice(name);
    this.update(name, { viewport });
    this.link.sendViewport(name, viewport);
  }

  close(name: SliceName): void {
    if (!this.store.state.slice_views[name].viewport) return;
    this.update(name, CLOSED_VIEW);
    this.link.closeSlice(name);
  }

  shown(name: SliceName, shown: ShownFrame): void {
    const picture = this.link.sliceShown(name, shown);
    if (this.store.state.slice_views[name].viewport) this.update(name, { shown, picture });
  }

  /** A new session knows of no view. */
  restart(): void {
    const { viewport, slice_views } = this.store.state;
    if (viewport) this.link.sendViewport('3d', viewport);
    for (const name of SLICE_NAMES) {
      const slice = slice_views[name].viewport;
      if (slice) this.link.sendViewport(name, slice);
    }
  }

  private update(name: SliceName, change: Partial<SliceView>): void {
    const { slice_views } = this.store.state;
    const slice = { ...slice_views[name], ...change };
    this.store.update({ slice_views: { ...slice_views, [name]: slice } });
  }
}
