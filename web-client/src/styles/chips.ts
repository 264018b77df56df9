// Small choices that lie side by side.
import { css } from 'lit';

export const chip_styles = css`
  .chip {
    padding: 4px 10px;
    border: 1px solid var(--line-strong);
    border-radius: 999px;
    background: transparent;
    color: var(--text);
    font-size: 12px;
  }
  .chip:hover:not(:disabled) {
    background: var(--surface-hover);
  }
  .chip[aria-pressed='true'] {
    border-color: var(--accent);
    background: var(--accent-quiet);
    color: var(--accent-strong);
  }
  @media (pointer: coarse) {
    .chip {
      min-height: 44px;
      padding: 4px 14px;
      font-size: 13px;
    }
  }
`;
