// Icons come from one sprite of this origin; Web Awesome's own libraries would fetch theirs from
// elsewhere.
import { registerIconLibrary } from '@awesome.me/webawesome/dist/components/icon/library.js';
import sprite from './icons.svg?url&no-inline';

const resolver = (name: string): string => `${sprite}#${name}`;

/**
 * A drawing from a sprite has no size of its own and would take 300 pixels. Lines are drawn as it is
 * said here, which the sprite's shapes inherit: a sprite's own styles reach them in Chromium alone.
 */
const DRAWN: Readonly<Record<string, string>> = {
  width: '1em',
  height: '1em',
  fill: 'none',
  stroke: 'currentColor',
  'stroke-width': '1.7',
  'stroke-linecap': 'round',
  'stroke-linejoin': 'round',
};

function draw(drawing: SVGElement): void {
  for (const [name, value] of Object.entries(DRAWN)) drawing.setAttribute(name, value);
}

for (const library of ['default', 'system']) {
  registerIconLibrary(library, { resolver, mutator: draw, spriteSheet: true });
}
