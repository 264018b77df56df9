// The scene as this page sees it: what the server last said, and on top of it the page's own
// changes that the server's word may not contain yet. So a slider stays where it was put while
// older answers arrive, and a refused change goes back to the last good value.
import { isAfter } from '../protocol/counter.ts';
import { isObject, mergePatch, type Json, type JsonObject } from './merge_patch.ts';
import { leftOpen, OPTIONAL_FIELDS } from './scene_fields.ts';

interface PendingChange {
  readonly input: number;
  readonly patch: JsonObject;
}

/** Older changes have arrived: a refusal would have been heard. Not every change makes a frame. */
const MOST_PENDING = 120;

/** Where null takes effect without an answer. */
const NOT_THERE = leftOpen(OPTIONAL_FIELDS);

/** Nulls ask the server to choose; until it has, the old value stays. */
function withoutNulls(patch: JsonObject, not_there: JsonObject = NOT_THERE): JsonObject {
  const kept = Object.entries(patch).filter(
    ([key, value]) => value !== null || not_there[key] === null,
  );
  const clean = ([key, value]: [string, Json]): [string, Json] => {
    const inner = not_there[key];
    return [key, isObject(value) ? withoutNulls(value, isObject(inner) ? inner : {}) : value];
  };
  return Object.fromEntries(kept.map(clean));
}

/** `patch` without the places that are null in `left_open`. */
function withoutPlaces(patch: JsonObject, left_open: JsonObject): JsonObject {
  const kept = Object.entries(patch).filter(([key]) => left_open[key] !== null);
  const clean = ([key, value]: [string, Json]): [string, Json] => {
    const inner = left_open[key];
    return [key, isObject(value) && isObject(inner) ? withoutPlaces(value, inner) : value];
  };
  return Object.fromEntries(kept.map(clean));
}

export class SceneSync {
  private base: JsonObject | undefined;
  private pending: readonly PendingChange[] = [];
  private staged: readonly JsonObject[] = [];

  /** Nothing before the first scene is known. */
  get scene(): JsonObject | undefined {
    if (!this.base) return undefined;
    const patches = [...this.pending.map((change) => change.patch), ...this.staged];
    return patches.reduce(mergePatch, this.base);
  }

  /** A change that will be sent, with others, within this animation frame. */
  stage(patch: JsonObject): void {
    this.staged = [...this.staged, patch];
  }

  /** `patch` went out under this number; it holds all that was staged. */
  sent(input: number, patch: JsonObject): void {
    this.staged = [];
    this.leaveOpen(patch);
    this.pending = [...this.pending, { input, patch: withoutNulls(patch) }];
    const oldest = this.pending.at(-MOST_PENDING - 1);
    if (oldest) this.shown(oldest.input);
  }

  /**
   * From here on the server says what is null in `left_open`: changes of it that are still on their
   * way are over, or they would come back on top of its answer.
   */
  leaveOpen(left_open: JsonObject): void {
    this.staged = this.staged.map((patch) => withoutPlaces(patch, left_open));
    this.pending = this.pending.map(({ input, patch }) => ({
      input,
      patch: withoutPlaces(patch, left_open),
    }));
  }

  /**
   * The server's whole scene. It may be older than the pending changes, which hence stay on top.
   */
  told(scene: JsonObject): void {
    this.base = scene;
  }

  /** A picture shows `input`: every change up to it has reached the server. */
  shown(input: number): void {
    if (!this.base) return;
    const reached = this.pending.filter((change) => !isAfter(change.input, input));
    this.base = reached.reduce((scene, change) => mergePatch(scene, change.patch), this.base);
    this.pending = this.pending.filter((change) => isAfter(change.input, input));
  }

  refused(input: number): void {
    this.pending = this.pending.filter((change) => change.input !== input);
  }

  /** A new session knows nothing; what it is sent as a whole becomes the base. */
  restart(scene: JsonObject | undefined): void {
    this.base = scene;
    this.pending = [];
    this.staged = [];
  }
}
