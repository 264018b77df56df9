import { describe, expect, it } from 'vitest';
import { newerThanFloor } from '../scripts/floor.mjs';

describe('the oldest browsers', () => {
  it('are not asked for newer syntax, calls or styles', () => {
    expect(newerThanFloor('class A { static { using x = y; } }', true)).toHaveLength(1);
    expect(newerThanFloor('export const a = Promise.try(b);', true)).toEqual([
      'Promise.try( needs Safari 18.2, Firefox 134',
    ]);
    expect(newerThanFloor('const s = css`a { color: light-dark(red, blue) }`', true)).toEqual([
      'light-dark( needs Safari 17.5',
    ]);
    expect(newerThanFloor('@starting-style { a { top: 0 } }', false)).toHaveLength(1);
  });

  it('may be asked for what they have', () => {
    expect(newerThanFloor('class A { static #b = 1; } export const c = a?.b ?? 1n;', true)).toEqual(
      [],
    );
    expect(newerThanFloor('a:state(b) { color: color-mix(in srgb, red, blue) }', false)).toEqual(
      [],
    );
  });
});
