// What exported pictures of one size are drawn on, to be written on.
import type { Viewport } from '../view/camera.ts';
import { drawLabels, measureWith } from './label_drawing.ts';
import { labelLayout } from './label_layout.ts';
import type { PictureLabels } from './picture_labels.ts';

export class PictureSheet {
  readonly canvas: OffscreenCanvas;
  private readonly context: OffscreenCanvasRenderingContext2D;

  /** Throws where the browser has no canvas of that size. `is_read`: its pixels, not only a video's. */
  constructor(
    private readonly size: Viewport,
    is_read: boolean,
  ) {
    this.canvas = new OffscreenCanvas(size.width_px, size.height_px);
    const context = this.canvas.getContext('2d', { willReadFrequently: is_read });
    if (!context) throw new Error('this browser offers no 2-D drawing');
    this.context = context;
  }

  /** The picture's own pixels, and the labels over them. */
  async draw(png: Blob, labels: PictureLabels): Promise<void> {
    const { context, size } = this;
    const picture = await createImageBitmap(png, { colorSpaceConversion: 'none' });
    context.drawImage(picture, 0, 0, size.width_px, size.height_px);
    picture.close();
    drawLabels(context, labelLayout(size, labels, measureWith(context)));
  }

  /** Throws where the canvas holds nothing: some browsers give ones too large for them, empty. */
  async png(): Promise<Blob> {
    const [, , , opacity] = this.context.getImageData(0, 0, 1, 1).data;
    if (!opacity) throw new Error('this browser has no canvas of that size');
    return this.canvas.convertToBlob({ type: 'image/png' });
  }
}
