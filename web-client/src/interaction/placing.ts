// Pointer and measuring tool: where a pointer hovers is read, a press that hardly moves places a
// point. A drag stays the camera's.

export interface PlacingTarget {
  /** Whether a tool is in hand. */
  readonly active: () => boolean;
  readonly hovered: (event: PointerEvent) => void;
  readonly left: () => void;
  readonly pressed: (event: PointerEvent) => void;
}

/** What a hand may slip in pressing, CSS pixels. */
export const SLIP_CSS_PX = 6;

interface Press {
  readonly pointer: number;
  readonly x: number;
  readonly y: number;
}

export function placeWithPointer(stage: HTMLElement, target: PlacingTarget): void {
  let press: Press | undefined;
  const held = new Set<number>();
  stage.addEventListener('pointerdown', (event) => {
    held.add(event.pointerId);
    const alone = held.size === 1 && event.button === 0 && !event.shiftKey && target.active();
    press = alone ? { pointer: event.pointerId, x: event.clientX, y: event.clientY } : undefined;
  });
  stage.addEventListener('pointermove', (event) => {
    if (press && slipped(press, event)) press = undefined;
    if (target.active() && event.buttons === 0 && event.pointerType !== 'touch')
      target.hovered(event);
  });
  stage.addEventListener('pointerup', (event) => {
    held.delete(event.pointerId);
    const placed = press?.pointer === event.pointerId && target.active();
    press = undefined;
    if (placed) target.pressed(event);
  });
  stage.addEventListener('pointercancel', (event) => {
    held.delete(event.pointerId);
    press = undefined;
  });
  stage.addEventListener('pointerleave', (event) => {
    if (target.active() && event.pointerType === 'mouse') target.left();
  });
}

function slipped(press: Press, { pointerId, clientX, clientY }: PointerEvent): boolean {
  const distance = Math.hypot(clientX - press.x, clientY - press.y);
  return pointerId === press.pointer && distance > SLIP_CSS_PX;
}
