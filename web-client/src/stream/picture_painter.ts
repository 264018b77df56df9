// Decodes pictures and paints them onto the page's canvas, off its main thread.
import type { FrameMessage } from '../protocol/frame_header.ts';

const MEDIA_TYPES = {
  live: 'image/jpeg',
  preview: 'image/jpeg',
  saved_still: 'image/png',
} as const;

export function pictureBlob({ header, picture }: FrameMessage): Blob {
  const type = header.lossless ? 'image/png' : MEDIA_TYPES[header.type];
  return new Blob([picture], { type });
}

export class PicturePainter {
  private readonly context: OffscreenCanvasRenderingContext2D;

  constructor(private readonly canvas: OffscreenCanvas) {
    const context = canvas.getContext('2d', { alpha: false });
    if (!context) throw new Error('this browser offers no 2-D drawing in a worker');
    this.context = context;
  }

  /** Throws where the picture cannot be decoded. */
  async paint(message: FrameMessage): Promise<void> {
    const bitmap = await createImageBitmap(pictureBlob(message));
    try {
      this.fit(message.header.viewport_width_px, message.header.viewport_height_px);
      this.context.imageSmoothingQuality = 'high';
      this.context.drawImage(bitmap, 0, 0, this.canvas.width, this.canvas.height);
    } finally {
      bitmap.close();
    }
  }

  /** Setting a canvas' size clears it, so only a change may do it. */
  private fit(width_px: number, height_px: number): void {
    if (this.canvas.width !== width_px) this.canvas.width = width_px;
    if (this.canvas.height !== height_px) this.canvas.height = height_px;
  }
}
