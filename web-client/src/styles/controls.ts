// What the controls of the panel look like in common: a heading with its value, and numbers.
import { css } from 'lit';

export const control_styles = css`
  :host {
    display: block;
    font-size: 13px;
  }
  .head {
    display: flex;
    justify-content: space-between;
    align-items: center;
    gap: 8px;
    min-height: 26px;
  }
  input[type='number'] {
    background: transparent;
    color: var(--text);
    font: inherit;
    font-variant-numeric: tabular-nums;
    text-align: right;
    appearance: textfield;
    -moz-appearance: textfield;
  }
  input[type='number']::-webkit-inner-spin-button {
    display: none;
  }
`;
