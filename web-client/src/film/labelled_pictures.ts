// Pictures of one size with their labels drawn on them. Imported only once there are some to draw.
import type { Viewport } from '../view/camera.ts';
import type { FilmFrame } from './film.ts';
import { pictureLabels, type LabelSubject } from './picture_labels.ts';
import { PictureSheet } from './picture_sheet.ts';

export interface Labelling {
  readonly subject: LabelSubject;
  /** Is told where the browser cannot draw on pictures of that size. */
  readonly refused: () => void;
}

/** Lossless, as they came. */
export class PngLabeller {
  private sheet: PictureSheet | undefined;
  private is_refused = false;

  constructor(private readonly labelling: Labelling) {}

  /** The picture as it came where the browser cannot draw on it; that is told once. */
  async label({ png, scene }: FilmFrame): Promise<Blob> {
    if (this.is_refused) return png;
    const { subject, refused } = this.labelling;
    const labels = pictureLabels(subject, scene);
    try {
      this.sheet ??= new PictureSheet(subject.size, true);
      await this.sheet.draw(png, labels);
      return await this.sheet.png();
    } catch {
      this.is_refused = true;
      refused();
      return png;
    }
  }
}

/** What a video's frames are drawn on: with their labels, or the notice alone. */
export class FrameSheet {
  private readonly sheet: PictureSheet;

  /** Throws where the browser has no canvas of that size. */
  constructor(
    size: Viewport,
    private readonly notice: string,
    private readonly labelling: Labelling | undefined,
  ) {
    this.sheet = new PictureSheet(size, false);
  }

  get canvas(): OffscreenCanvas {
    return this.sheet.canvas;
  }

  async draw({ png, scene }: FilmFrame): Promise<void> {
    const { notice, labelling } = this;
    await this.sheet.draw(png, labelling ? pictureLabels(labelling.subject, scene) : { notice });
  }
}
