import type { SCENE_FIELDS } from '../protocol/messages.ts';

type Fields = typeof SCENE_FIELDS;

/** Those fields of the scene that the schema describes. */
export type DescribedField = {
  [Field in keyof Fields]: Fields[Field] extends { description: string } ? Field : never;
}[keyof Fields];

/** Those with a control of one kind. */
export type FieldOfKind<Kind extends string> = {
  [Field in DescribedField]: Fields[Field] extends { kind: Kind } ? Field : never;
}[DescribedField];
