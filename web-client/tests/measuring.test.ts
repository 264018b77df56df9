import { beforeEach, describe, expect, it, vi } from 'vitest';
import { applyKey } from '../src/interaction/keyboard.ts';
import { measurementsOf } from '../src/state/measure_state.ts';
import type { Vector3 } from '../src/view/vector.ts';
import { sceneMessage, volume } from './capabilities.ts';
import { frame, Harness } from './harness.ts';

let harness: Harness;
beforeEach(async () => {
  harness = new Harness();
  await harness.connect();
  harness.say(sceneMessage);
});

const picks = () => harness.sent.filter((message) => message.type === 'pick');
const list = () => measurementsOf(harness.state.measure, harness.state.volume);
const measured = () => harness.session.measured;
const measuring = () => harness.session.measuring;

/** Answers the last pick. */
function answer(...position_mm: Vector3 | []): void {
  const { request } = picks().at(-1) ?? { request: 0 };
  const [x, y, z] = position_mm;
  harness.say(
    x === undefined
      ? { type: 'picked', request }
      : {
          type: 'picked',
          request,
          position_mm: [x, y ?? 0, z ?? 0],
          value: 300,
          units: 'HU',
          branch: 'focus',
        },
  );
}

function place(...position_mm: Vector3): void {
  measuring().place('3d', [10, 10]);
  answer(...position_mm);
}

const press = (key: string, shiftKey = false, altKey = false): boolean => {
  const preventDefault = vi.fn();
  const event = { key, shiftKey, altKey, ctrlKey: false, metaKey: false, preventDefault };
  applyKey(event as unknown as KeyboardEvent, harness.session, { view: '3d', device_pixels: 2 });
  return preventDefault.mock.calls.length > 0;
};

describe('a distance', () => {
  it('is two points that the server finds, with a name and in the list', () => {
    measuring().take('distance');
    place(0, 0, 0);
    expect(list()).toEqual([]);
    expect(harness.state.measure.draft?.points).toHaveLength(1);
    place(0, 30, 40);
    expect(list()).toMatchObject([
      {
        kind: 'distance',
        name: 'Distance 1',
        points: [{ value: 300 }, { position_mm: [0, 30, 40] }],
      },
    ]);
    place(1, 1, 1);
    place(2, 2, 2);
    expect(list().map(({ name }) => name)).toEqual(['Distance 1', 'Distance 2']);
  });

  it('takes no point where nothing is, and says so', () => {
    measuring().take('distance');
    measuring().place('3d', [10, 10]);
    answer();
    expect(harness.state.measure.draft?.points).toEqual([]);
    expect(harness.state.toasts).toMatchObject([{ title: 'No surface here' }]);
  });

  it('asks for what the user sees: a change that waits goes out first', () => {
    measuring().take('distance');
    harness.session.commands.orbit(10, 0);
    measuring().place('3d', [10, 10]);
    expect(harness.sent.slice(-2).map(({ type }) => type)).toEqual(['scene', 'pick']);
  });

  it('is not placed by an answer that comes after the tool was put away', () => {
    measuring().take('probe');
    measuring().place('3d', [10, 10]);
    measuring().take('probe');
    answer(1, 2, 3);
    expect(list()).toEqual([]);
  });
});

describe('the point under the pointer', () => {
  it('is asked for one at a time, and then the newest', () => {
    measuring().take('probe');
    for (const x of [1, 2, 3]) measuring().point('3d', [x, 0]);
    expect(picks().map(({ position_px }) => position_px)).toEqual([[1, 0]]);
    answer(1, 1, 1);
    expect(harness.state.measure.candidate).toMatchObject({ answered: false, position_px: [3, 0] });
    expect(picks().map(({ position_px }) => position_px)).toEqual([
      [1, 0],
      [3, 0],
    ]);
    answer(3, 3, 3);
    expect(harness.state.measure.candidate).toMatchObject({
      answered: true,
      found: { position_mm: [3, 3, 3], value: 300 },
    });
  });

  it('is asked for anew once the picture has changed', () => {
    measuring().take('probe');
    measuring().point('3d', [5, 5]);
    answer(1, 1, 1);
    harness.emit({ kind: 'shown', frame: { ...frame(1, 1), still: true } });
    expect(picks()).toHaveLength(2);
  });

  it('is none without a tool, and none after the pointer has left', () => {
    measuring().point('3d', [5, 5]);
    expect(picks()).toEqual([]);
    measuring().take('probe');
    measuring().point('3d', [5, 5]);
    measuring().pointAway();
    answer(1, 1, 1);
    expect(harness.state.measure.candidate).toBeUndefined();
  });

  it('waits for no answer of a connection that was lost', () => {
    measuring().take('probe');
    measuring().point('3d', [5, 5]);
    harness.emit({ kind: 'link', state: { phase: 'connecting' } });
    measuring().point('3d', [6, 6]);
    expect(picks()).toHaveLength(2);
  });
});

describe('the keyboard', () => {
  it('takes tools, moves the point and places it', () => {
    expect(press('Enter')).toBe(false);
    press('m');
    press('ArrowRight');
    expect(harness.state.measure.candidate?.position_px).toEqual([400, 300]);
    press('ArrowRight');
    press('ArrowUp', true);
    expect(harness.state.measure.candidate).toMatchObject({
      position_px: [424, 298],
      by_keys: true,
    });
    press('Enter');
    answer(1, 1, 1);
    expect(harness.state.measure.draft?.points).toHaveLength(1);
    expect(harness.scenes().filter(({ scene }) => 'camera' in scene)).toEqual([]);
  });

  it('keeps the point within the picture', () => {
    press('v');
    measuring().point('3d', [1, 1], true);
    press('ArrowLeft');
    press('ArrowUp');
    expect(harness.state.measure.candidate?.position_px).toEqual([0, 0]);
  });

  it('gives up with Escape: the points, the tool, the choice', () => {
    press('m');
    place(1, 1, 1);
    expect(press('Escape')).toBe(true);
    expect(harness.state.measure.draft).toEqual({ kind: 'distance', points: [] });
    press('Escape');
    expect(harness.state.measure.draft).toBeUndefined();
    expect(press('Escape')).toBe(false);
  });

  it('takes the last point back', () => {
    press('a');
    place(1, 1, 1);
    place(2, 2, 2);
    press('Backspace');
    expect(harness.state.measure.draft?.points).toHaveLength(1);
  });

  it('turns and pans the view with Alt while a tool is in hand', () => {
    press('m');
    const before = harness.state.scene?.camera;
    expect(press('ArrowRight', false, true)).toBe(true);
    const turned = harness.state.scene?.camera;
    expect(turned?.eye_mm).not.toEqual(before?.eye_mm);
    expect(turned?.target_mm).toEqual(before?.target_mm);
    press('ArrowRight', true, true);
    expect(harness.state.scene?.camera?.target_mm).not.toEqual(before?.target_mm);
    expect(harness.state.measure.candidate).toBeUndefined();
  });

  it('is the camera’s without a tool', () => {
    press('ArrowRight');
    harness.nextFrame();
    expect(harness.scenes().at(-1)?.scene).toHaveProperty('camera');
  });
});

describe('what was measured', () => {
  beforeEach(() => {
    measuring().take('probe');
    place(1, 2, 3);
  });
  const [id] = [1];

  it('is chosen, moved over the surface, renamed and deleted', () => {
    expect(harness.state.measure.selected).toBe(id);
    measuring().movePoint(id, 0, '3d', [20, 20]);
    answer(4, 5, 6);
    measuring().movePoint(id, 0, '3d', [30, 20]);
    answer();
    measured().rename(id, 'Apex');
    expect(list()).toMatchObject([{ name: 'Apex', points: [{ position_mm: [4, 5, 6] }] }]);
    measured().remove(id);
    expect(list()).toEqual([]);
    expect(harness.state.measure.selected).toBeUndefined();
  });

  it('stays with its volume', () => {
    const knee = { ...volume, id: 'knee' };
    harness.say({ ...sceneMessage, revision: 2, volume: knee });
    expect(list()).toEqual([]);
    expect(harness.state.measure.draft).toEqual({ kind: 'probe', points: [] });
    place(7, 7, 7);
    harness.say({ ...sceneMessage, revision: 3 });
    expect(list().map(({ points }) => points[0]?.position_mm)).toEqual([[1, 2, 3]]);
  });

  it('survives a lost connection', () => {
    harness.emit({ kind: 'link', state: { phase: 'connecting' } });
    expect(list()).toHaveLength(1);
  });

  it('is there on the next visit, and counts on from there', async () => {
    const again = new Harness('', Object.fromEntries(harness.kept));
    again.session.measured.restore();
    await again.connect();
    again.say(sceneMessage);
    harness = again;
    expect(list()).toMatchObject([{ name: 'Probe 1', points: [{ position_mm: [1, 2, 3] }] }]);
    measuring().take('probe');
    place(4, 4, 4);
    expect(new Set(list().map((one) => one.id)).size).toBe(2);
  });

  it('is put aside where it cannot be read', () => {
    const kept = '{"version":1,"volumes":[["head",[{"name":"x","kind":"distance","points":[]}]]]}';
    harness = new Harness('', { 'cutaway.measurements': kept });
    measured().restore();
    expect(harness.state.toasts).toMatchObject([
      { title: 'Your saved measurements could not be read' },
    ]);
    expect(harness.kept.get('cutaway.measurements.unreadable')).toBe(kept);
  });

  it('lasts as long as the page where the browser keeps nothing', () => {
    harness.kept.set = () => {
      throw new Error('full');
    };
    place(5, 5, 5);
    place(6, 6, 6);
    expect(list()).toHaveLength(3);
    expect(harness.state.toasts).toHaveLength(1);
  });

  const undo = (): void => harness.state.toasts.at(-1)?.action?.run();

  it('comes back where it was once a deletion is undone', () => {
    place(2, 2, 2);
    measured().remove(id);
    place(3, 3, 3);
    undo();
    expect(list().map(({ points }) => points[0]?.position_mm)).toEqual([
      [1, 2, 3],
      [2, 2, 2],
      [3, 3, 3],
    ]);
    measured().removeAll();
    expect(harness.kept.get('cutaway.measurements')).toBe('{"version":1,"volumes":[]}');
    undo();
    expect(list()).toHaveLength(3);
  });

  it('is undone and redone like everything else, in the storage too', () => {
    const { commands } = harness.session;
    const names = () => list().map(({ name }) => name);
    const sent = harness.sent.length;
    measured().rename(id, 'Valve');
    measured().remove(id);
    commands.undo();
    expect(names()).toEqual(['Valve']);
    expect(harness.kept.get('cutaway.measurements')).toContain('Valve');
    commands.undo();
    expect(names()).toEqual(['Probe 1']);
    commands.undo();
    expect(list()).toEqual([]);
    commands.redo();
    commands.redo();
    expect(names()).toEqual(['Valve']);
    commands.redo();
    expect(list()).toEqual([]);
    expect(harness.kept.get('cutaway.measurements')).toBe('{"version":1,"volumes":[]}');
    expect(harness.sent).toHaveLength(sent);
  });

  it('has its point back after a drag in one step, and is not chosen once it is gone', () => {
    const { commands } = harness.session;
    measuring().take('probe');
    measuring().select(id);
    harness.session.store.update({ pointer_held: true });
    for (const x of [4, 5, 6]) {
      measuring().movePoint(id, 0, '3d', [x, x]);
      answer(x, x, x);
    }
    harness.session.store.update({ pointer_held: false });
    expect(list()[0]?.points[0]?.position_mm).toEqual([6, 6, 6]);
    commands.undo();
    expect(list()[0]?.points[0]?.position_mm).toEqual([1, 2, 3]);
    expect(harness.state.measure.selected).toBe(id);
    commands.undo();
    expect(harness.state.measure.selected).toBeUndefined();
  });

  it('comes back to its volume although another was opened', () => {
    measured().remove(id);
    harness.say({ ...sceneMessage, revision: 2, volume: { ...volume, id: 'knee' } });
    undo();
    expect(list()).toEqual([]);
    harness.say({ ...sceneMessage, revision: 3 });
    expect(list()).toHaveLength(1);
  });

  it('is saved as a file by the volume’s name', async () => {
    measured().exportAs('csv', 'Not for diagnostic use');
    measured().exportAs('json', 'Not for diagnostic use');
    expect(harness.saved.map(([name]) => name)).toEqual([
      'cutaway Head measurements.csv',
      'cutaway Head measurements.json',
    ]);
    expect(await harness.saved[0]?.[1].text()).toContain('Probe 1,probe,300,HU,1,2,3,300');
  });
});
