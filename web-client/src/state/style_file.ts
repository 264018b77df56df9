// A look in a file: a scene document. What such a file cannot be is found here; whether the server
// knows all that is in it, the server says when it is put on.
import { SCENE_GROUPS, SCENE_VERSION, STYLE_FIELDS } from '../protocol/messages.ts';
import { isObject, type JsonObject } from './merge_patch.ts';
import { cleanTitle, lookOf, ownStyle, type OwnStyle } from './own_styles.ts';
import { words } from '../words/words.ts';

/** Its text is for the user, and says why a file was refused. */
export class StyleFileError extends Error {}

/** No document is longer than a message may be. */
export const LARGEST_FILE_BYTES = 64 * 1024;

export const styleFileText = ({ scene }: OwnStyle): string => `${JSON.stringify(scene, null, 2)}\n`;

function parsed(text: string): JsonObject {
  let document: unknown;
  try {
    document = JSON.parse(text);
  } catch (error) {
    throw new StyleFileError(
      words().own_styles.not_json(error instanceof Error ? error.message : ''),
    );
  }
  if (!isObject(document)) throw new StyleFileError(words().own_styles.not_an_object);
  return document;
}

function check(document: JsonObject, fields: readonly string[]): void {
  const { version = SCENE_VERSION } = document;
  if (version !== SCENE_VERSION)
    throw new StyleFileError(
      words().own_styles.other_version(JSON.stringify(version), SCENE_VERSION),
    );
  const unknown = Object.keys(document).find((field) => !fields.includes(field));
  if (unknown !== undefined) throw new StyleFileError(words().own_styles.unknown_field(unknown));
}

/** 'My look.scene.json' is 'My look'. */
const titleOfFile = (file_name: string): string => file_name.replace(/(\.scene)?\.json$/i, '');

/**
 * From a scene document, whose name is the file's, or from a style of the server's. Throws
 * StyleFileError.
 */
export function styleFromFile(text: string, file_name: string): OwnStyle {
  const document = parsed(text);
  const is_style = isObject(document['scene']);
  check(document, is_style ? STYLE_FIELDS : SCENE_GROUPS);
  const scene = isObject(document['scene']) ? document['scene'] : document;
  if (is_style) check(scene, SCENE_GROUPS);
  if (Object.keys(lookOf(scene)).length === 0) throw new StyleFileError(words().own_styles.no_look);
  const title = typeof document['title'] === 'string' ? document['title'] : titleOfFile(file_name);
  return ownStyle(cleanTitle(title) || words().own_styles.untitled, scene);
}
