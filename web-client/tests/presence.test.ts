import { beforeEach, describe, expect, it } from 'vitest';
import { Harness } from './harness.ts';

describe('presence', () => {
  let harness: Harness;
  const told = () =>
    harness.sent.filter((message) => message.type === 'presence').map((message) => message.visible);
  const giveWay = () => harness.emit({ kind: 'link', state: { phase: 'gave_way' } });
  const see = (visible: boolean) => {
    harness.page_visible = visible;
    harness.seen();
  };

  beforeEach(async () => {
    harness = new Harness();
    await harness.connect();
  });

  it('is told when a session begins and whenever it changes', () => {
    expect(told()).toEqual([true]);
    see(false);
    see(true);
    expect(told()).toEqual([true, false, true]);
  });

  it('is told of a hidden page, too', async () => {
    harness = new Harness();
    harness.page_visible = false;
    await harness.connect();
    expect(told()).toEqual([false]);
  });

  it('brings a session back that gave way, once the page is seen again', () => {
    see(false);
    giveWay();
    harness.used();
    expect(harness.connections_wanted).toBe(0);
    see(true);
    expect(harness.connections_wanted).toBe(1);
  });

  it('brings it back at the first touch where the page was in sight all along', () => {
    giveWay();
    expect(harness.connections_wanted).toBe(0);
    harness.used();
    expect(harness.connections_wanted).toBe(1);
  });

  it('leaves a connection alone that there is', () => {
    harness.used();
    see(false);
    see(true);
    expect(harness.connections_wanted).toBe(0);
  });

  it('says nothing more than the page does of a session that gave way', () => {
    harness.say({ type: 'error', code: 'gave-way', message: 'others waited' });
    expect(harness.state.toasts).toEqual([]);
  });
});
