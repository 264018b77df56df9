// Icons come from one sprite of this origin; Web Awesome's own libraries would fetch theirs from
// elsewhere.
import { registerIconLibrary } from '@awesome.me/webawesome/dist/components/icon/library.js';
import sprite from './icons.svg?url&no-inline';

const resolver = (name: string): string => `${sprite}#${name}`;

/** A drawing from a sprite has no size of its own and would take 300 pixels. */
function sized(drawing: SVGElement): void {
  drawing.setAttribute('width', '1em');
  drawing.setAttribute('height', '1em');
}

for (const library of ['default', 'system']) {
  registerIconLibrary(library, { resolver, mutator: sized, spriteSheet: true });
}
