import { describe, expect, it, vi } from 'vitest';
import { LatePart } from '../src/components/late_part.ts';
import { Toasts } from '../src/session/toasts.ts';
import { INITIAL_STATE } from '../src/state/viewer_state.ts';
import { Store } from '../src/state/store.ts';

describe('code that comes later', () => {
  const store = new Store(INITIAL_STATE);
  const toasts = new Toasts(store);
  const give_up = vi.fn();
  const part = (load: () => Promise<unknown>) => {
    const requestUpdate = vi.fn();
    const host = { requestUpdate } as unknown as ConstructorParameters<typeof LatePart>[0];
    return { late: new LatePart(host, load), requestUpdate };
  };

  it('is asked for once, and draws its host again', async () => {
    const load = vi.fn(() => Promise.resolve());
    const { late, requestUpdate } = part(load);
    await Promise.all([late.ask(toasts, give_up), late.ask(toasts, give_up)]);
    expect(give_up).not.toHaveBeenCalled();
    expect(load).toHaveBeenCalledTimes(1);
    expect(late.is_there).toBe(true);
    expect(requestUpdate).toHaveBeenCalledTimes(1);
    expect(store.state.toasts).toEqual([]);
  });

  it('is said to be missing where it cannot be had, and is asked for again', async () => {
    const load = vi.fn(() => Promise.reject(new Error('404')));
    const { late, requestUpdate } = part(load);
    await late.ask(toasts, give_up);
    await late.ask(toasts, give_up);
    expect(late.is_there).toBe(false);
    expect(load).toHaveBeenCalledTimes(2);
    expect(give_up).toHaveBeenCalledTimes(2);
    expect(requestUpdate).not.toHaveBeenCalled();
    expect(store.state.toasts).toMatchObject([{ title: 'A part of the page could not be loaded' }]);
  });
});
