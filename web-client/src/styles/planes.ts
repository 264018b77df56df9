// Each plane has its colour wherever it is named or drawn; light enough for lines on a dark picture.
import { css } from 'lit';

export const plane_colours = css`
  .axial {
    --plane: #ff7a70;
  }
  .coronal {
    --plane: #6fdc8c;
  }
  .sagittal {
    --plane: #ffd84d;
  }
`;
