// A point of the picture under a finger or a button: it goes where the pointer goes, keeping its
// distance from it, so that a finger does not hide it.
import { Directive, directive, PartType, type ElementPart, type PartInfo } from 'lit/directive.js';
import { noChange } from 'lit';
import type { Point } from '../view/camera.ts';

export interface HeldPoint {
  /** Of the picture, device pixels. */
  readonly pointOf: (event: PointerEvent) => Point;
  /** Where the point is now. */
  readonly start_px: Point;
  readonly moved: (to_px: Point) => void;
}

class HeldPointDirective extends Directive {
  private held: HeldPoint | undefined;
  private offset_px: Point | undefined;
  private listens = false;

  constructor(part: PartInfo) {
    super(part);
    if (part.type !== PartType.ELEMENT) throw new Error('a held point is an element');
  }

  override update(part: ElementPart, [held]: [HeldPoint]): typeof noChange {
    this.held = held;
    if (!this.listens) this.listen(part.element as HTMLElement);
    this.listens = true;
    return noChange;
  }

  render(_held: HeldPoint): typeof noChange {
    return noChange;
  }

  private listen(element: HTMLElement): void {
    element.addEventListener('pointerdown', (event) => {
      if (!this.held) return;
      element.setPointerCapture(event.pointerId);
      event.stopPropagation();
      const [x, y] = this.held.pointOf(event);
      this.offset_px = [this.held.start_px[0] - x, this.held.start_px[1] - y];
    });
    element.addEventListener('pointermove', (event) => {
      if (!this.held || !this.offset_px || !element.hasPointerCapture(event.pointerId)) return;
      const [x, y] = this.held.pointOf(event);
      this.held.moved([x + this.offset_px[0], y + this.offset_px[1]]);
    });
    for (const end of ['pointerup', 'pointercancel'] as const)
      element.addEventListener(end, () => (this.offset_px = undefined));
  }
}

export const heldPoint = directive(HeldPointDirective);
