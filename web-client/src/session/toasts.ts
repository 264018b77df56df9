// Messages that come and go. The same one twice does not stack up.
import type { Store } from '../state/store.ts';
import type { Toast, ToastAction, ViewerState } from '../state/viewer_state.ts';

const MOST = 3;

export class Toasts {
  private last_id = 0;

  constructor(private readonly store: Store<ViewerState>) {}

  problem(title: string, detail: string): void {
    this.add('problem', title, detail);
  }

  /** `action` is a button in it. */
  note(title: string, detail = '', action?: ToastAction): void {
    this.add('note', title, detail, action);
  }

  dismiss(id: number): void {
    this.store.update({ toasts: this.store.state.toasts.filter((toast) => toast.id !== id) });
  }

  private add(tone: Toast['tone'], title: string, detail: string, action?: ToastAction): void {
    this.last_id += 1;
    const others = this.store.state.toasts.filter(
      (toast) => toast.title !== title || toast.detail !== detail,
    );
    this.store.update({
      toasts: [
        ...others,
        { id: this.last_id, tone, title, detail, ...(action && { action }) },
      ].slice(-MOST),
    });
  }
}
