// All that a frame of a film depends on, so that the user may go on changing the session's scene
// while the film is made.
import type { Scene } from '../protocol/messages.ts';
import { layered, type JsonObject } from '../state/merge_patch.ts';
import { fieldsOf, leftOpen, OPTIONAL_FIELDS, withoutFields } from '../state/scene_fields.ts';

/** What a picture of a session cannot have of its own. */
const OF_THE_SESSION = [...fieldsOf('document'), ['volume']];

/** What is not there says so: the session's may have got one in between. */
const NOT_THERE = leftOpen(OPTIONAL_FIELDS);

/** A patch that makes any scene of the same volume look like `scene`. */
export const wholeScene = (scene: Scene): JsonObject =>
  layered(NOT_THERE, withoutFields(scene as JsonObject, OF_THE_SESSION));
