// Where an event of the pointer lies in the picture.
import type { Point, Viewport } from '../view/camera.ts';
import { elementToPicture } from '../view/picture_fit.ts';

/** Device pixels of the picture that `element` shows; CSS pixels while its size is not known. */
export function picturePoint(
  { clientX, clientY }: MouseEvent,
  element: Element,
  viewport: Viewport | undefined,
): Point {
  const box = element.getBoundingClientRect();
  const place: Point = [clientX - box.left, clientY - box.top];
  return viewport ? elementToPicture(place, viewport, box) : place;
}
