// Places larger than the pictures that the server draws: a smaller picture is asked for, and enlarged.
import type { Limits } from '../protocol/messages.ts';
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { Viewport } from '../view/camera.ts';
import { words } from '../words/words.ts';
import type { Toasts } from './toasts.ts';

type ViewportLimits = Pick<Limits, 'viewport_side_px' | 'viewport_pixels'>;

/** The largest viewport of the same shape that the server's limits allow, once they are known. */
export function withinLimits(viewport: Viewport, limits: ViewportLimits | undefined): Viewport {
  if (!limits) return viewport;
  const { width_px, height_px } = viewport;
  const shrink = Math.min(
    1,
    limits.viewport_side_px / Math.max(width_px, height_px),
    Math.sqrt(limits.viewport_pixels / (width_px * height_px)),
  );
  if (shrink === 1) return viewport;
  const fit = (side: number): number => Math.max(1, Math.floor(side * shrink));
  return { width_px: fit(width_px), height_px: fit(height_px) };
}

export class ViewportFit {
  private is_said = false;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly toasts: Toasts,
  ) {}

  /** The viewport for a picture's place. The first one that is smaller than its place is told of. */
  within(place: Viewport): Viewport {
    const wanted = withinLimits(place, this.store.state.capabilities?.limits);
    if (wanted !== place) this.tell(place, wanted);
    return wanted;
  }

  private tell(place: Viewport, wanted: Viewport): void {
    if (this.is_said) return;
    this.is_said = true;
    const { picture_enlarged, picture_enlarged_detail } = words().messages;
    const size = ({ width_px, height_px }: Viewport): string => `${width_px} × ${height_px}`;
    this.toasts.note(picture_enlarged, picture_enlarged_detail(size(wanted), size(place)));
  }
}
