// Whether a button is held or a finger is down, anywhere on the page.

export function observeHeldPointer(changed: (held: boolean) => void): void {
  const held = new Set<number>();
  const listen = (type: 'pointerdown' | 'pointerup' | 'pointercancel'): void =>
    window.addEventListener(
      type,
      ({ pointerId }) => {
        if (type === 'pointerdown') held.add(pointerId);
        else held.delete(pointerId);
        changed(held.size > 0);
      },
      { capture: true },
    );
  listen('pointerdown');
  listen('pointerup');
  listen('pointercancel');
}
