// Pictures of the volumes that can be opened, each as it first appears. The server opens a volume
// for its picture, so one is asked for at a time, only of those that can be seen, and kept for as
// long as the page lives.
import type { Store } from '../state/store.ts';
import type { ViewerState } from '../state/viewer_state.ts';
import type { Viewport } from '../view/camera.ts';
import type { PreviewRequests } from './preview_requests.ts';

export class VolumePictures {
  private wanted: readonly string[] = [];
  private size: Viewport | undefined;
  private asking: string | undefined;

  constructor(
    private readonly store: Store<ViewerState>,
    private readonly requests: PreviewRequests,
  ) {
    store.subscribe(() => this.askNext());
  }

  /** Ids of the volumes that are in sight, those to be drawn first in front; none without a list. */
  want(volumes: readonly string[], size: Viewport | undefined): void {
    this.wanted = volumes;
    this.size = size ?? this.size;
    this.askNext();
  }

  /** A new connection: what the last one was asked for will not come, and what failed there may do. */
  restart(): void {
    this.asking = undefined;
    const pictures = [...this.store.state.volume_pictures];
    const good = pictures.filter(([, picture]) => picture !== 'failed');
    if (good.length < pictures.length) this.store.update({ volume_pictures: new Map(good) });
  }

  private askNext(): void {
    const { volume_pictures } = this.store.state;
    const volume = this.wanted.find((id) => !volume_pictures.has(id));
    const { size } = this;
    if (volume === undefined || !size || this.asking !== undefined || !this.mayAsk()) return;
    this.asking = volume;
    this.requests.ask({ volume, ...size }, (picture) => {
      this.asking = undefined;
      this.keep(volume, picture ?? 'failed');
    });
  }

  /** Not while the user waits for a picture. */
  private mayAsk(): boolean {
    const { link, loading, pointer_held, shown } = this.store.state;
    return link.phase === 'connected' && !loading && !pointer_held && shown?.still === true;
  }

  private keep(volume: string, picture: ImageBitmap | 'failed'): void {
    const { volume_pictures } = this.store.state;
    this.store.update({ volume_pictures: new Map(volume_pictures).set(volume, picture) });
  }
}
