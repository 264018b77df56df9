// Drawings over the whole picture, which the pointer goes through.
import { css } from 'lit';

export const overlay_styles = css`
  :host {
    position: absolute;
    inset: 0;
    pointer-events: none;
  }
  svg {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    overflow: hidden;
  }
`;
