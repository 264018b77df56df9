// A choice that shows what it gives: of the list of volumes and of the gallery.
import { css } from 'lit';

/** Declarations, to stand in a rule. */
export const card_look = css`
  width: 100%;
  padding: 0;
  border: 1px solid var(--line);
  border-radius: var(--radius);
  background: var(--surface-raised);
  text-align: left;
  overflow: hidden;
  transition:
    background 120ms,
    border-color 120ms;
`;
