import { describe, expect, it, vi } from 'vitest';
import { afterFirstPicture, LatePart } from '../src/components/late_part.ts';
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

  it('may come before it is asked for, and is silent where it cannot', async () => {
    const quiet = vi.fn();
    const load = vi.fn(() => Promise.resolve());
    load.mockRejectedValueOnce(new Error('404'));
    const { late, requestUpdate } = part(load);
    store.update({ toasts: [] });
    await late.foresee();
    expect(late.is_there).toBe(false);
    expect(store.state.toasts).toEqual([]);
    await Promise.all([late.foresee(), late.ask(toasts, quiet)]);
    await late.foresee();
    expect(late.is_there).toBe(true);
    expect(quiet).not.toHaveBeenCalled();
    expect(load).toHaveBeenCalledTimes(2);
    expect(requestUpdate).toHaveBeenCalledTimes(1);
  });

  it('is said to be missing where it was asked for while it came by itself', async () => {
    const closed = vi.fn();
    const { late } = part(() => Promise.reject(new Error('404')));
    await Promise.all([late.foresee(), late.ask(toasts, closed)]);
    expect(closed).toHaveBeenCalledTimes(1);
    expect(store.state.toasts).toMatchObject([{ title: 'A part of the page could not be loaded' }]);
  });

  it('waits for the first picture, once', () => {
    const shown = {} as NonNullable<typeof INITIAL_STATE.shown>;
    const waiting = new Store(INITIAL_STATE);
    const run = vi.fn();
    afterFirstPicture(waiting, run);
    waiting.update({ help_open: true });
    expect(run).not.toHaveBeenCalled();
    waiting.update({ shown });
    waiting.update({ shown: { ...shown } });
    expect(run).toHaveBeenCalledTimes(1);
    afterFirstPicture(waiting, run);
    expect(run).toHaveBeenCalledTimes(2);
  });
});
