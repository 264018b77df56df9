// A scene in the page's address, as the page writes it itself.
import { deflateRawSync } from 'node:zlib';

export const linkTo = (scene) =>
  `#1.${deflateRawSync(JSON.stringify(scene)).toString('base64url')}`;
