import { beforeEach, describe, expect, it, vi } from 'vitest';
import { measurementsOf } from '../src/state/measure_state.ts';
import type { Vector3 } from '../src/view/vector.ts';
import { sceneMessage, volume } from './capabilities.ts';
import { Harness } from './harness.ts';

let harness: Harness;

const list = () => measurementsOf(harness.state.measure, harness.state.volume);
const measured = () => harness.session.measured;

/** With the tool in hand. */
function place(...[x, y, z]: Vector3): void {
  harness.session.measuring.place('3d', [10, 10]);
  const pick = harness.sent.findLast((message) => message.type === 'pick');
  harness.say({
    type: 'picked',
    request: pick?.request ?? 0,
    position_mm: [x, y, z],
    value: 300,
    units: 'HU',
    branch: 'focus',
  });
}

describe('what was measured', () => {
  beforeEach(async () => {
    harness = new Harness();
    await harness.connect();
    harness.say(sceneMessage);
    harness.session.measuring.take('probe');
    place(1, 2, 3);
  });

  describe('in another volume of the same name', () => {
    const other = { ...volume, origin_mm: [-2, -2, 40] as [number, number, number] };
    const open = (opened: typeof volume, revision: number): void =>
      harness.say({ ...sceneMessage, revision, volume: opened });

    it('is neither listed nor destroyed, and that is said', () => {
      open(other, 2);
      expect(list()).toEqual([]);
      expect(harness.state.measure.draft?.points).toEqual([]);
      expect(harness.state.toasts).toMatchObject([
        { title: 'Measured in another volume of this name; not shown' },
      ]);
      place(7, 7, 7);
      open(volume, 3);
      expect(list().map(({ points }) => points[0]?.position_mm)).toEqual([[1, 2, 3]]);
    });

    it('is not said of a volume that is told again, or whose numbers are rounded otherwise', () => {
      open({ ...volume, value_range: [-1000.00001, 3000] }, 2);
      expect(list()).toHaveLength(1);
      expect(harness.state.toasts).toEqual([]);
    });

    const keptById = (position_mm: Vector3): Record<string, string> => {
      const probe = { name: 'Old', kind: 'probe', points: [{ position_mm, value: 1 }] };
      return {
        'cutaway.measurements': JSON.stringify({ version: 1, volumes: [['head', [probe]]] }),
      };
    };
    const visit = async (kept: Record<string, string>): Promise<void> => {
      harness = new Harness('', kept);
      harness.session.measured.restore();
      await harness.connect();
      open(volume, 1);
    };

    it('is taken over, not as a step, where the volume was kept by its id and holds it', async () => {
      await visit(keptById([1, 2, 3]));
      expect(list()).toMatchObject([{ name: 'Old' }]);
      measured().rename(list()[0]?.id ?? 0, 'New');
      harness.session.commands.undo();
      harness.session.commands.undo();
      expect(list()).toMatchObject([{ name: 'Old' }]);
      expect(harness.state.toasts).toEqual([]);
      await visit(Object.fromEntries(harness.kept));
      expect(list()).toMatchObject([{ name: 'Old' }]);
      open(other, 2);
      expect(list()).toEqual([]);
    });

    it('stays aside where it lies beyond the volume', async () => {
      const kept = keptById([1, 2, 300]);
      await visit(kept);
      expect(list()).toEqual([]);
      expect(harness.state.toasts).toHaveLength(1);
      expect(Object.fromEntries(harness.kept)).toMatchObject(kept);
    });
  });

  describe('on two pages', () => {
    let first: Harness;
    let second: Harness;
    /** What one page has saved is there for the other. */
    const told = (by: Harness, to: Harness): void => {
      for (const [key, text] of by.kept) to.kept.set(key, text);
      to.storageChanged('cutaway.measurements');
    };
    const names = (page: Harness): readonly string[] =>
      measurementsOf(page.state.measure, page.state.volume).map(({ name }) => name);
    const openPage = async (kept: Record<string, string>): Promise<Harness> => {
      const page = new Harness('', kept);
      page.session.measured.restore();
      await page.connect();
      page.say(sceneMessage);
      return page;
    };
    beforeEach(async () => {
      first = await openPage(Object.fromEntries(harness.kept));
      second = await openPage(Object.fromEntries(harness.kept));
    });
    const measureIn = (page: Harness, ...position_mm: Vector3): void => {
      harness = page;
      harness.session.measuring.take('probe');
      place(...position_mm);
      harness.session.measuring.take('probe');
    };

    it('is not destroyed by the other’s save', () => {
      measureIn(second, 2, 2, 2);
      told(second, first);
      measureIn(first, 3, 3, 3);
      expect(names(first)).toEqual(['Probe 1', 'Probe 2', 'Probe 3']);
      told(first, second);
      expect(names(second)).toEqual(names(first));
    });

    it('is not saved back, keeps what is chosen, and is no step', () => {
      measureIn(first, 3, 3, 3);
      const { selected } = first.state.measure;
      told(first, second);
      measureIn(second, 2, 2, 2);
      const set = vi.spyOn(first.kept, 'set');
      told(second, first);
      expect(set.mock.calls.filter(([key]) => key === 'cutaway.measurements')).toHaveLength(1);
      expect(first.state.measure.selected).toBe(selected);
      first.session.commands.undo();
      expect(names(first)).toEqual(['Probe 1', 'Probe 2', 'Probe 3']);
    });

    it('goes with the other’s deletion', () => {
      second.session.measured.removeAll();
      told(second, first);
      expect(names(first)).toEqual([]);
    });

    it('leaves alone what another page keeps besides, and what cannot be read', () => {
      first.kept.set('cutaway.measurements', 'damaged');
      first.storageChanged('cutaway.styles');
      first.storageChanged('cutaway.measurements');
      expect(names(first)).toEqual(['Probe 1']);
    });
  });
});
