// Parts of the export dialog.
import { css } from 'lit';

export const export_styles = css`
  :host {
    display: grid;
    gap: 12px;
  }
  .primary {
    border-color: var(--accent);
    background: var(--accent);
    color: var(--on-accent);
    font-weight: 600;
  }
  .primary:hover:not(:disabled) {
    border-color: var(--accent-strong);
    background: var(--accent-strong);
  }
`;
