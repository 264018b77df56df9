// Asks the server what lies under a point of the picture.
import type { Counter } from '../protocol/counter.ts';
import type { PickedMessage } from '../protocol/messages.ts';
import type { Stream } from '../stream/stream.ts';
import { viewNumber, type ViewName } from '../state/views.ts';
import type { Point } from '../view/camera.ts';
import type { Vector3 } from '../view/vector.ts';

export interface Pick {
  /** Patient space, LPS, mm. */
  readonly position_mm: Vector3;
  /** Physical value there, in the volume's units. */
  readonly value: number;
  /** Whose surface it is; a slice has none. */
  readonly branch?: 'focus' | 'context';
}

/** Hears what was hit; nothing where there was no surface, or no answer came. */
export type PickListener = (pick: Pick | undefined) => void;

function pickOf({ position_mm, value, branch }: PickedMessage): Pick | undefined {
  if (!position_mm || value === undefined) return undefined;
  return { position_mm, value, ...(branch && { branch }) };
}

export class Picker {
  private readonly outstanding = new Map<number, PickListener>();

  constructor(
    private readonly stream: Stream,
    private readonly requests: Counter,
    /** Sends what the user has changed already: the server answers for the scene that it knows. */
    private readonly flush: () => void,
  ) {}

  /** `position_px` is device pixels of the view's picture. `answered` is called later, once. */
  pick(view: ViewName, position_px: Point, answered: PickListener): void {
    const request = this.requests.next();
    this.outstanding.set(request, answered);
    this.flush();
    const [x, y] = position_px;
    this.stream.send({ type: 'pick', view: viewNumber(view), request, position_px: [x, y] });
  }

  arrived(message: PickedMessage): void {
    this.settle(message.request, pickOf(message));
  }

  /** Whether the refused request was a pick. */
  refused(request: number | undefined): boolean {
    return request !== undefined && this.settle(request, undefined);
  }

  /** What a lost connection was asked will not be answered. */
  restart(): void {
    for (const request of [...this.outstanding.keys()]) this.settle(request, undefined);
  }

  private settle(request: number, pick: Pick | undefined): boolean {
    const answered = this.outstanding.get(request);
    this.outstanding.delete(request);
    answered?.(pick);
    return answered !== undefined;
  }
}

interface Asked {
  readonly view: ViewName;
  readonly position_px: Point;
  readonly answered: PickListener;
}

/** Picks that follow a pointer: one is asked at a time, and then the newest that waits. */
export class PickFollower {
  private waiting: Asked | undefined;
  private current: PickListener | undefined;
  private asking = false;

  constructor(private readonly picker: Picker) {}

  follow(view: ViewName, position_px: Point, answered: PickListener): void {
    this.waiting = { view, position_px, answered };
    this.askNext();
  }

  /** The pointer has left: what waits is not asked any more, and no answer is heard. */
  stop(): void {
    this.waiting = undefined;
    this.current = undefined;
  }

  private askNext(): void {
    const { waiting } = this;
    if (this.asking || !waiting) return;
    this.waiting = undefined;
    this.asking = true;
    this.current = waiting.answered;
    this.picker.pick(waiting.view, waiting.position_px, (pick) => {
      this.asking = false;
      this.current?.(pick);
      this.askNext();
    });
  }
}
