// The lens goes where the pointer is, without a button held: until Escape, or until a drag of the
// camera begins.

export interface FollowTarget {
  follows(): boolean;
  moved(event: PointerEvent): void;
  ended(): void;
}

/** `picture` has everything that lies over the picture, `stage` takes the camera's gestures. */
export function followWithLens(
  picture: HTMLElement,
  stage: HTMLElement,
  target: FollowTarget,
): void {
  const end = (): void => {
    if (target.follows()) target.ended();
  };
  picture.addEventListener('pointermove', (event) => {
    const hovers = event.buttons === 0 && event.pointerType !== 'touch';
    if (hovers && target.follows()) target.moved(event);
  });
  stage.addEventListener('pointerdown', end);
  window.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') end();
  });
}
