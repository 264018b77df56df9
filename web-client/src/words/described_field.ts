import type { SCENE_FIELDS } from '../protocol/messages.ts';

type Fields = typeof SCENE_FIELDS;

/** Those fields of the scene that the schema describes. */
export type DescribedField = {
  [Field in keyof Fields]: Fields[Field] extends { description: string } ? Field : never;
}[keyof Fields];
