// How a control of the panel looks, beside what all of them share (styles/controls.ts).
import { css } from 'lit';

export const control_field_styles = css`
  .number {
    width: 72px;
    padding: 2px 6px;
    border: 1px solid transparent;
    border-radius: 6px;
  }
  .number:hover,
  .number:focus {
    border-color: var(--line-strong);
    background: var(--surface-raised);
  }
  .unit {
    margin-left: 2px;
    color: var(--text-quiet);
    font-size: 12px;
  }
  wa-slider {
    --track-size: 4px;
    --thumb-width: 16px;
    --thumb-height: 16px;
    display: block;
    margin: 2px 8px 4px;
  }
  wa-slider::part(indicator) {
    background: var(--accent);
  }
  wa-slider::part(track) {
    background: var(--line-strong);
  }
  wa-slider::part(label) {
    display: none;
  }
  wa-select {
    width: 100%;
  }
  wa-select::part(form-control-label) {
    margin-bottom: 4px;
    font-size: 13px;
    font-weight: 400;
  }
  wa-select::part(display-input) {
    font-size: 13px;
  }
  .row {
    display: flex;
    align-items: center;
    justify-content: space-between;
    min-height: 36px;
  }
  input[type='color'] {
    width: 48px;
    height: 28px;
    padding: 2px;
    border: 1px solid var(--line-strong);
    border-radius: 7px;
    background: transparent;
    cursor: pointer;
  }
  wa-switch {
    display: flex;
    flex: 1;
    --height: 20px;
    --thumb-size: 12px;
    font-size: 13px;
  }
  /* The label to the left, the switch where other controls have their value. */
  wa-switch::part(switch) {
    display: flex;
    flex: 1;
    flex-direction: row-reverse;
    justify-content: space-between;
  }
  wa-switch::part(label) {
    margin: 0;
  }
  @media (pointer: coarse) {
    .row {
      min-height: 44px;
    }
    wa-switch {
      --height: 26px;
      --thumb-size: 18px;
    }
    input[type='color'] {
      width: 64px;
      height: 44px;
    }
    .number {
      min-height: 44px;
    }
    wa-select::part(combobox),
    wa-option {
      min-height: 44px;
    }
    wa-slider {
      --thumb-width: 24px;
      --thumb-height: 24px;
      margin: 8px 12px 10px;
    }
  }
`;
