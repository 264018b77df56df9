// Measurements stand out from every style: a light green with a dark rim, the chosen one in the
// page's accent.
import { css } from 'lit';

export const measure_overlay_styles = css`
  :host {
    --mark: #7df0c8;
    overflow: hidden;
  }
  polyline,
  path {
    fill: none;
    stroke: var(--mark);
    stroke-width: 2;
    stroke-linecap: round;
    stroke-linejoin: round;
    vector-effect: non-scaling-stroke;
  }
  .halo {
    stroke: rgb(0 0 0 / 55%);
    stroke-width: 4.5;
  }
  circle {
    fill: var(--mark);
    stroke: rgb(0 0 0 / 60%);
    stroke-width: 1.5;
    vector-effect: non-scaling-stroke;
  }
  .chosen {
    --mark: #ffbe7d;
  }
  .off {
    opacity: 0.3;
  }
  .draft polyline:not(.halo) {
    stroke-dasharray: 6 5;
  }
  .label {
    position: absolute;
    transform: translate(-50%, calc(-100% - 9px));
    padding: 2px 7px;
    border: 1px solid rgb(255 255 255 / 14%);
    border-radius: 6px;
    background: rgb(10 13 15 / 82%);
    color: var(--mark);
    font: 600 12px/1.4 var(--font);
    font-variant-numeric: tabular-nums;
    white-space: nowrap;
  }
  .label.beside {
    transform: translate(12px, -50%);
  }
  .label.on {
    transform: translate(-50%, -50%);
  }
  .pressable {
    pointer-events: auto;
  }
  @media (pointer: coarse) {
    .pressable::after {
      content: '';
      position: absolute;
      inset: -11px 0;
    }
  }
  .name {
    margin-right: 6px;
    color: #e9eef1;
    font-weight: 400;
  }
  .handle {
    position: absolute;
    width: 44px;
    height: 44px;
    margin: -22px 0 0 -22px;
    padding: 0;
    border: 0;
    border-radius: 50%;
    background: transparent;
    cursor: move;
    touch-action: none;
    pointer-events: auto;
  }
  .handle::after {
    content: '';
    position: absolute;
    inset: 13px;
    border: 1.5px solid #ffbe7d;
    border-radius: 50%;
    box-shadow: 0 0 0 1px rgb(0 0 0 / 50%);
  }
  .handle:hover::after {
    background: rgb(242 166 90 / 30%);
  }
`;
