// All that a frame of a film depends on, so that the user may go on changing the session's scene
// while the film is made.
import type { Scene } from '../protocol/messages.ts';
import { isObject, omit, type Json, type JsonObject } from '../state/merge_patch.ts';

/** What a picture of a session cannot have of its own. */
const OF_THE_SESSION = ['version', 'volume', 'viewport'];

/** A band that has no upper end says so: the session's may have got one in between. */
const NO_UPPER_END = { surface: { upper_value: null } };

/** A patch that makes any scene of the same volume look like `scene`. */
export function wholeScene(scene: Scene): JsonObject {
  const fields = omit(scene as JsonObject, OF_THE_SESSION);
  return layered({ focus: NO_UPPER_END, context: NO_UPPER_END }, fields);
}

/** Both patches, `above` where they disagree. */
function layered(below: JsonObject, above: JsonObject): JsonObject {
  const both = Object.entries(above).map(([key, value]): [string, Json] => {
    const under = below[key];
    return [key, isObject(under) && isObject(value) ? layered(under, value) : value];
  });
  return { ...below, ...Object.fromEntries(both) };
}
