// Headings within a section of the panel.
import { css } from 'lit';

export const headings = css`
  h3 {
    margin: 6px 0 0;
    color: var(--text-quiet);
    font-size: 12px;
    font-weight: 500;
  }
`;
