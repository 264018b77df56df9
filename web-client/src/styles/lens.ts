// The grips of the lens, in 3-D and in slices.
import { css } from 'lit';

export const lens_styles = css`
  button {
    position: absolute;
    display: grid;
    place-items: center;
    width: 44px;
    height: 44px;
    margin: -22px 0 0 -22px;
    padding: 0;
    border: 0;
    border-radius: 50%;
    background: transparent;
    color: #fff;
    touch-action: none;
    pointer-events: auto;
  }
  .grip {
    display: grid;
    place-items: center;
    width: 30px;
    height: 30px;
    border: 1.5px solid rgb(255 255 255 / 80%);
    border-radius: 50%;
    background: rgb(10 13 15 / 58%);
    opacity: 0.75;
    transition: opacity 120ms;
  }
  .turn .grip {
    width: 22px;
    height: 22px;
    font-size: 12px;
  }
  .turn {
    cursor: grab;
  }
  .size .grip {
    width: 16px;
    height: 16px;
    background: rgb(10 13 15 / 80%);
  }
  button:hover .grip,
  button:focus-visible .grip,
  .dragging .grip {
    opacity: 1;
    background: var(--on-picture-accent);
    color: var(--on-picture-on-accent);
  }
  .move {
    cursor: grab;
  }
  .move.dragging {
    cursor: grabbing;
  }
  .size {
    cursor: ew-resize;
  }
`;
