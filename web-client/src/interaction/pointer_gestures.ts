// Mouse, pen and touch over a picture. What a button or one finger does, the picture says; two
// fingers pan and pinch. Distances are CSS pixels.

export interface Drag {
  readonly dx: number;
  readonly dy: number;
  /** The newest event, and where the press was, in the page. */
  readonly event: PointerEvent;
  readonly start: { readonly x: number; readonly y: number };
}

export interface Pinch {
  readonly dx: number;
  readonly dy: number;
  readonly magnification: number;
  /** Between the fingers, in the page. */
  readonly x: number;
  readonly y: number;
}

export interface PointerTarget<Motion> {
  readonly motionOf: (event: PointerEvent) => Motion;
  readonly dragged: (motion: Motion, drag: Drag) => void;
  readonly pinched: (pinch: Pinch) => void;
  /** A press that moved nothing, and was alone. */
  readonly pressed?: (motion: Motion, event: PointerEvent) => void;
  /** How far a press may slip before it moves anything. */
  readonly slip_css_px: () => number;
}

export const MIDDLE_BUTTON = 1;
export const RIGHT_BUTTON = 2;

const ZOOM_PER_CSS_PIXEL = 0.006;

/** Of a drag that zooms: upward is larger. */
export const magnificationOf = ({ dy }: Drag): number => Math.exp(-dy * ZOOM_PER_CSS_PIXEL);

interface Pointer<Motion> {
  x: number;
  y: number;
  /** Has gone farther than a hand slips. */
  moves: boolean;
  readonly start: { readonly x: number; readonly y: number };
  readonly motion: Motion;
}

interface Pair {
  readonly x: number;
  readonly y: number;
  readonly distance: number;
}

function pairOf([first, second]: readonly { x: number; y: number }[]): Pair | undefined {
  if (!first || !second) return undefined;
  const distance = Math.max(1, Math.hypot(first.x - second.x, first.y - second.y));
  return { x: (first.x + second.x) / 2, y: (first.y + second.y) / 2, distance };
}

export class PointerGestures<Motion> {
  private readonly pointers = new Map<number, Pointer<Motion>>();

  constructor(
    private readonly surface: HTMLElement,
    private readonly target: PointerTarget<Motion>,
  ) {
    surface.addEventListener('pointerdown', (event) => this.down(event));
    surface.addEventListener('pointermove', (event) => this.moved(event));
    surface.addEventListener('pointerup', (event) => this.up(event));
    for (const end of ['pointercancel', 'lostpointercapture'] as const) {
      surface.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
    surface.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  private down(event: PointerEvent): void {
    if (event.pointerType === 'mouse' && this.pointers.size > 0) return;
    if (event.button === MIDDLE_BUTTON) event.preventDefault();
    this.surface.setPointerCapture(event.pointerId);
    const place = { x: event.clientX, y: event.clientY };
    const motion = this.target.motionOf(event);
    // A second finger makes a pinch of it, which is no press.
    for (const other of this.pointers.values()) other.moves = true;
    const moves = this.pointers.size > 0;
    this.pointers.set(event.pointerId, { ...place, start: place, moves, motion });
  }

  private moved(event: PointerEvent): void {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const before = pairOf([...this.pointers.values()]);
    const dx = event.clientX - pointer.x;
    const dy = event.clientY - pointer.y;
    pointer.moves ||= Math.hypot(dx, dy) > this.target.slip_css_px();
    if (!pointer.moves) return;
    pointer.x = event.clientX;
    pointer.y = event.clientY;
    if (before) this.pairMoved(before);
    else this.target.dragged(pointer.motion, { dx, dy, event, start: pointer.start });
  }

  private up(event: PointerEvent): void {
    const pointer = this.pointers.get(event.pointerId);
    this.pointers.delete(event.pointerId);
    if (pointer && !pointer.moves) this.target.pressed?.(pointer.motion, event);
  }

  private pairMoved(before: Pair): void {
    const after = pairOf([...this.pointers.values()]);
    if (!after) return;
    const { x, y } = after;
    const magnification = after.distance / before.distance;
    this.target.pinched({ dx: x - before.x, dy: y - before.y, magnification, x, y });
  }
}
