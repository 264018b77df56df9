import { css } from 'lit';

export const band_editor_styles = css`
  :host {
    display: grid;
    gap: 6px;
    font-size: 13px;
  }
  .tissues {
    display: flex;
    flex-wrap: wrap;
    gap: 6px;
  }
  .plot {
    position: relative;
    margin: 4px 10px 0;
    padding-bottom: 9px;
    cursor: ew-resize;
    touch-action: pan-y;
  }
  .handle {
    position: absolute;
    bottom: -6px;
    width: 20px;
    height: 30px;
    margin-left: -10px;
    padding: 0;
    border: 0;
    background: transparent;
    cursor: ew-resize;
    touch-action: none;
  }
  .handle::after {
    content: '';
    position: absolute;
    left: 2px;
    bottom: 4px;
    width: 16px;
    height: 16px;
    border-radius: 50%;
    background: var(--accent);
    box-shadow: 0 0 0 2px var(--surface);
  }
  .handle:focus-visible {
    outline: 0;
  }
  .handle:focus-visible::after {
    outline: 2px solid var(--accent);
    outline-offset: 3px;
  }
  .range {
    display: flex;
    justify-content: space-between;
    margin: 0 10px;
    color: var(--text-quiet);
    font-size: 11px;
    font-variant-numeric: tabular-nums;
  }
  @media (pointer: coarse) {
    .plot {
      margin: 4px 14px 4px;
      padding-bottom: 14px;
    }
    .handle {
      bottom: -12px;
      width: 44px;
      height: 44px;
      margin-left: -22px;
    }
    .handle::after {
      left: 10px;
      bottom: 8px;
      width: 24px;
      height: 24px;
    }
    .range {
      margin: 0 14px;
    }
  }
`;
