// What the server left out because it came too fast is sent again.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { ErrorMessage } from '../src/protocol/messages.ts';
import { sceneMessage } from './capabilities.ts';
import { Harness } from './harness.ts';

const TOO_FAST: ErrorMessage = {
  type: 'error',
  code: 'rate-limited',
  message: 'messages come too fast; some were not heeded',
};

describe('a refusal that names no message', () => {
  let harness: Harness;
  beforeEach(async () => {
    harness = new Harness();
    await harness.connect();
    harness.say(sceneMessage);
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  const sentAfter = (ms: number) => {
    harness.sent.length = 0;
    vi.advanceTimersByTime(ms);
    return [...harness.sent];
  };
  const scenesAfter = (ms: number) =>
    sentAfter(ms).flatMap((message) => (message.type === 'scene' ? [message.scene] : []));
  const change = (radius_mm: number) => {
    harness.session.commands.set(['lens', 'radius_mm'], radius_mm);
    harness.nextFrame();
  };

  it('sends the scene as the controls have it, once', () => {
    change(12);
    harness.say(TOO_FAST);
    const [scene, ...others] = scenesAfter(1_600);
    expect(scene).toMatchObject({ lens: { radius_mm: 12 } });
    expect(scene).toHaveProperty('camera');
    expect(scene).not.toHaveProperty('volume');
    expect(others).toEqual([]);
    expect(sentAfter(60_000)).toEqual([]);
  });

  it('waits until the refusals are over', () => {
    for (let second = 0; second < 5; second++) {
      change(10 + second);
      harness.say(TOO_FAST);
      expect(scenesAfter(1_000)).toEqual([]);
    }
    expect(scenesAfter(600)).toMatchObject([{ lens: { radius_mm: 14 } }]);
  });

  it('sends again where what was sent again was refused', () => {
    change(12);
    harness.say(TOO_FAST);
    expect(scenesAfter(1_600)).toHaveLength(1);
    harness.say(TOO_FAST);
    expect(scenesAfter(1_600)).toMatchObject([{ lens: { radius_mm: 12 } }]);
  });

  it('tells of the size of the picture and of the page, too', () => {
    harness.say(TOO_FAST);
    const types = sentAfter(1_600).map(({ type }) => type);
    expect(types).toContain('viewport');
    expect(types).toContain('presence');
  });

  it('asks anew for what the server chooses, where nothing was asked since', () => {
    harness.session.commands.resetView();
    harness.say(TOO_FAST);
    const [whole, asked] = scenesAfter(1_600);
    expect(whole).toHaveProperty('camera.eye_mm');
    expect(asked).toMatchObject({ camera: null });

    harness.session.commands.resetView();
    harness.say(TOO_FAST);
    change(13);
    expect(scenesAfter(1_600)).toMatchObject([{ lens: { radius_mm: 13 } }]);

    harness.session.commands.resetView();
    harness.say(TOO_FAST);
    harness.say({ ...sceneMessage, revision: 9, input: harness.state.sent_input });
    expect(scenesAfter(1_600)).toHaveLength(1);
  });

  it('drags the lens there again', () => {
    harness.session.commands.dragLens([10, 20]);
    harness.nextFrame();
    harness.say(TOO_FAST);
    const drags = sentAfter(1_600).filter(({ type }) => type === 'drag_lens');
    expect(drags).toMatchObject([{ position_px: [10, 20] }]);
  });

  it('wants the other volume again, and spells nothing out for it', () => {
    harness.session.commands.openVolume('knee');
    harness.say(TOO_FAST);
    expect(scenesAfter(1_600)).toEqual([{ volume: 'knee' }]);
  });

  it('waits for a volume that is opened', () => {
    harness.session.commands.openVolume('knee');
    harness.say({ type: 'loading', volume: 'knee', stage: 'read', fraction: 0 });
    harness.say(TOO_FAST);
    expect(sentAfter(10_000)).toEqual([]);
    harness.say({ type: 'loading', volume: 'knee', stage: 'failed', fraction: 1 });
    expect(scenesAfter(1_600)).toHaveLength(1);
  });

  it('is forgotten with the connection, and not taken for one of a request', () => {
    harness.say({ ...TOO_FAST, request: 4 });
    expect(sentAfter(10_000)).toEqual([]);
    harness.say(TOO_FAST);
    harness.emit({ kind: 'link', state: { phase: 'connected' } });
    expect(sentAfter(10_000)).toEqual([]);
  });

  it('ends a pick that nobody will answer, so that the next is asked', () => {
    const picks = () => harness.sent.filter(({ type }) => type === 'pick');
    harness.session.slicing.readout.point('axial', [1, 2]);
    harness.session.slicing.readout.point('axial', [3, 4]);
    expect(picks()).toHaveLength(1);
    harness.say(TOO_FAST);
    expect(picks()).toMatchObject([{ position_px: [1, 2] }, { position_px: [3, 4] }]);
  });
});
