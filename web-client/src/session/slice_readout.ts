// Asks what lies under the pointer in a slice. The pointer may rest while the picture becomes another.
import type { SliceHover } from '../state/slice_pointing.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import { isSameVolume } from '../state/volume_identity.ts';
import type { Point } from '../view/camera.ts';
import type { SliceName } from '../view/slice_geometry.ts';
import { PickFollower, type Picker } from './picker.ts';

/** What was found is of no use any more. */
const isOutdated = (state: ViewerState, before: ViewerState): boolean =>
  !isSameVolume(state.volume, before.volume) ||
  (state.link.phase !== 'connected' && before.link.phase === 'connected');

export class SliceReadout {
  private readonly follower: PickFollower;

  constructor(
    private readonly store: Store<ViewerState>,
    picker: Picker,
  ) {
    this.follower = new PickFollower(picker);
    store.subscribe((state, before) => this.changed(state, before));
  }

  /** The pointer is there. */
  point(slice: SliceName, position_px: Point): void {
    const { hover } = this;
    const found = hover?.slice === slice ? hover.found : undefined;
    this.update({ slice, position_px, found });
    this.ask(slice, position_px);
  }

  pointAway(): void {
    this.follower.stop();
    this.update(undefined);
  }

  private ask(slice: SliceName, position_px: Point): void {
    this.follower.follow(slice, position_px, (found) => {
      if (this.hover?.slice === slice) this.update({ ...this.hover, found });
    });
  }

  private changed(state: ViewerState, before: ViewerState): void {
    const { slice_hover: hover } = state;
    if (!hover) return;
    const { viewport, shown } = state.slice_views[hover.slice];
    if (!viewport) return this.pointAway();
    if (isOutdated(state, before)) {
      this.follower.stop();
      this.update({ ...hover, found: undefined });
    } else if (shown !== before.slice_views[hover.slice].shown) {
      this.ask(hover.slice, hover.position_px);
    }
  }

  private get hover(): SliceHover | undefined {
    return this.store.state.slice_hover;
  }

  private update(slice_hover: SliceHover | undefined): void {
    this.store.update({ slice_hover });
  }
}
