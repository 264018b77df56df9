// Mouse, pen and touch over the picture: left drag or one finger rotates, middle or Shift+left or
// two fingers pan, right drag or pinch zooms. Distances go out in device pixels.

export interface GestureTarget {
  orbit(dx_px: number, dy_px: number): void;
  pan(dx_px: number, dy_px: number): void;
  zoom(magnification: number): void;
}

type Motion = 'orbit' | 'pan' | 'zoom';

interface Pointer {
  x: number;
  y: number;
  /** Has gone farther than a hand slips. */
  moves: boolean;
  readonly motion: Motion;
}

const ZOOM_PER_CSS_PIXEL = 0.006;
const MIDDLE_BUTTON = 1;
const RIGHT_BUTTON = 2;

function motionOf(event: PointerEvent): Motion {
  if (event.button === MIDDLE_BUTTON) return 'pan';
  if (event.button === RIGHT_BUTTON) return 'zoom';
  return event.shiftKey ? 'pan' : 'orbit';
}

interface Pair {
  readonly x: number;
  readonly y: number;
  readonly distance: number;
}

function pairOf([first, second]: readonly Pointer[]): Pair | undefined {
  if (!first || !second) return undefined;
  const distance = Math.max(1, Math.hypot(first.x - second.x, first.y - second.y));
  return { x: (first.x + second.x) / 2, y: (first.y + second.y) / 2, distance };
}

export class PointerGestures {
  private readonly pointers = new Map<number, Pointer>();

  /** `device_pixels` gives how many of them a CSS pixel of the surface has. */
  constructor(
    private readonly surface: HTMLElement,
    private readonly target: GestureTarget,
    private readonly device_pixels: () => number,
    /** How far a press may slip before it moves anything, CSS pixels. */
    private readonly slip_css_px: () => number,
  ) {
    surface.addEventListener('pointerdown', (event) => this.down(event));
    surface.addEventListener('pointermove', (event) => this.moved(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
      surface.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
    surface.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  private down(event: PointerEvent): void {
    if (event.pointerType === 'mouse' && this.pointers.size > 0) return;
    if (event.button === MIDDLE_BUTTON) event.preventDefault();
    this.surface.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, {
      x: event.clientX,
      y: event.clientY,
      moves: false,
      motion: motionOf(event),
    });
  }

  private moved(event: PointerEvent): void {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const before = pairOf([...this.pointers.values()]);
    const dx = event.clientX - pointer.x;
    const dy = event.clientY - pointer.y;
    pointer.moves ||= Math.hypot(dx, dy) > this.slip_css_px() || before !== undefined;
    if (!pointer.moves) return;
    pointer.x = event.clientX;
    pointer.y = event.clientY;
    if (before) this.pairMoved(before);
    else this.singleMoved(pointer.motion, dx, dy);
  }

  private singleMoved(motion: Motion, dx: number, dy: number): void {
    const scale = this.device_pixels();
    if (motion === 'orbit') this.target.orbit(dx * scale, dy * scale);
    else if (motion === 'pan') this.target.pan(dx * scale, dy * scale);
    else this.target.zoom(Math.exp(-dy * ZOOM_PER_CSS_PIXEL));
  }

  private pairMoved(before: Pair): void {
    const after = pairOf([...this.pointers.values()]);
    if (!after) return;
    const scale = this.device_pixels();
    this.target.pan((after.x - before.x) * scale, (after.y - before.y) * scale);
    this.target.zoom(after.distance / before.distance);
  }
}
