// Icons come from one sprite of this origin; Web Awesome's own libraries would fetch theirs from
// elsewhere.
import { registerIconLibrary } from '@awesome.me/webawesome/dist/components/icon/library.js';
import sprite from './icons.svg?url&no-inline';

const resolver = (name: string): string => `${sprite}#${name}`;

for (const library of ['default', 'system'])
  registerIconLibrary(library, { resolver, spriteSheet: true });
