// The named styles by what they are for.
import type { Style } from '../protocol/messages.ts';

export type StyleGroup = NonNullable<Style['group']>;

const DEFAULT_GROUP: StyleGroup = 'illustration';

export const groupOf = (style: Style | undefined): StyleGroup => style?.group ?? DEFAULT_GROUP;

/** In the order that the server gives. */
export const stylesOf = (group: StyleGroup, styles: readonly Style[]): readonly Style[] =>
  styles.filter((style) => groupOf(style) === group);
