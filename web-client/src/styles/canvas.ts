// A picture that the server sends, in 3-D or of a slice, and the surface that takes its gestures.
import { css } from 'lit';

export const canvas_styles = css`
  :host {
    position: relative;
    display: block;
    overflow: hidden;
    background: var(--page);
    /* What lies over a small picture takes less room. */
    container-type: size;
  }
  .stage {
    position: absolute;
    inset: 0;
    touch-action: none;
    user-select: none;
    -webkit-user-select: none;
  }
  .stage:focus-visible {
    outline-offset: -2px;
  }
  canvas {
    display: block;
    width: 100%;
    height: 100%;
    object-fit: contain;
    transition:
      opacity 200ms,
      filter 200ms;
  }
  .offline canvas {
    opacity: 0.4;
    filter: grayscale(0.6);
  }
`;
