// Numbers that count up by 1 and wrap around to 0 after 2^32-1.

export class Counter {
  private current = 0;

  next(): number {
    this.current = (this.current + 1) >>> 0;
    return this.current;
  }
}

/** Whether `a` comes after `b`. */
export function isAfter(a: number, b: number): boolean {
  return ((a - b) | 0) > 0;
}
