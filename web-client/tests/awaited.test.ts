// Whether the picture of an input is still to come.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { awaitsPicture } from '../src/state/viewer_state.ts';
import { sceneMessage } from './capabilities.ts';
import { frame, Harness } from './harness.ts';

let harness: Harness;
beforeEach(async () => {
  harness = new Harness();
  await harness.connect();
});

describe('an input that changes nothing in the picture', () => {
  const told = (revision: number) => {
    const { volume: _, ...later } = sceneMessage;
    harness.say({ ...later, revision, input: harness.state.sent_input });
  };

  beforeEach(() => {
    harness.say(sceneMessage);
    harness.emit({ kind: 'shown', frame: frame(harness.state.sent_input, 1) });
    harness.session.commands.set(['lens', 'radius_mm'], 12);
    harness.nextFrame();
  });

  it('is shown by the picture that comes after the word of it, and has an older input', () => {
    const made_of = harness.state.sent_input;
    harness.session.commands.set(['lens', 'radius_mm'], 12);
    harness.nextFrame();
    told(2);
    expect(awaitsPicture(harness.state)).toBe(true);
    harness.emit({ kind: 'shown', frame: frame(made_of, 2) });
    expect(awaitsPicture(harness.state)).toBe(false);
  });

  it('is not shown by a picture of the connection before, whose revisions are other ones', async () => {
    harness.emit({ kind: 'shown', frame: frame(harness.state.sent_input, 7) });
    await harness.connect();
    harness.session.commands.set(['lens', 'radius_mm'], 13);
    harness.nextFrame();
    harness.say({ ...sceneMessage, revision: 1, input: harness.state.sent_input });
    expect(awaitsPicture(harness.state)).toBe(true);
    harness.emit({ kind: 'shown', frame: frame(harness.state.sent_input, 1) });
    expect(awaitsPicture(harness.state)).toBe(false);
  });

  it('is not sent at all where the zoom is at its limit', () => {
    for (let notch = 0; notch < 200; notch++) harness.session.commands.zoom(0.5);
    harness.nextFrame();
    const sent = harness.scenes().length;
    harness.session.commands.zoom(0.5);
    harness.nextFrame();
    expect(harness.scenes()).toHaveLength(sent);
  });
});

describe('a server that does not answer', () => {
  beforeEach(() => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
    harness.say(sceneMessage);
    harness.emit({ kind: 'shown', frame: frame(harness.state.sent_input, 1) });
  });
  afterEach(() => vi.useRealTimers());

  it('is called stalled after a while, until a picture comes', () => {
    harness.session.commands.resetView();
    vi.advanceTimersByTime(5_000);
    expect(harness.state.stalled).toBe(false);
    vi.advanceTimersByTime(5_000);
    expect(harness.state.stalled).toBe(true);
    harness.emit({ kind: 'shown', frame: frame(harness.state.sent_input, 2) });
    expect(harness.state.stalled).toBe(false);
  });

  it('is not while pictures come, however old', () => {
    const { sent_input } = harness.state;
    harness.session.commands.resetView();
    for (let picture = 0; picture < 4; picture++) {
      vi.advanceTimersByTime(4_000);
      harness.emit({ kind: 'shown', frame: frame(sent_input, 2) });
    }
    expect(harness.state.stalled).toBe(false);
  });

  it('is not where it says that the input changed nothing in the picture', () => {
    harness.session.commands.resetView();
    harness.say({ ...sceneMessage, input: harness.state.sent_input });
    vi.advanceTimersByTime(60_000);
    expect(harness.state.stalled).toBe(false);
  });

  it('is not where it refuses the input, which no picture will show', () => {
    harness.session.commands.resetView();
    const { sent_input: input } = harness.state;
    harness.say({ type: 'error', code: 'out-of-range', message: 'no', input });
    vi.advanceTimersByTime(60_000);
    expect(harness.state.stalled).toBe(false);
  });

  it('is where the scene that it says is yet to be seen', () => {
    harness.session.commands.resetView();
    const { lens, ...rest } = sceneMessage.scene;
    const moved = { ...rest, lens: { ...lens, radius_mm: 7 } };
    harness.say({ ...sceneMessage, revision: 2, input: harness.state.sent_input, scene: moved });
    vi.advanceTimersByTime(10_000);
    expect(harness.state.stalled).toBe(true);
  });

  it('is not while nothing was asked of it', () => {
    vi.advanceTimersByTime(60_000);
    expect(harness.state.stalled).toBe(false);
  });
});
