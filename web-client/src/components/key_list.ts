// The keys, in groups, as the keyboards of the page's language have them.
import { html } from 'lit';
import type { KeyGroup } from '../interaction/key_binding.ts';
import { KEY_BINDINGS } from '../interaction/keyboard.ts';
import { words } from '../words/words.ts';

/** 'Ctrl + Z' is 'Strg + Z' on a German keyboard. */
function keyCaps(keys: string): string {
  const caps: Readonly<Record<string, string>> = words().keys.caps;
  return keys.replaceAll(/\p{L}+/gu, (name) => caps[name] ?? name);
}

export function keyList() {
  const { groups, meanings } = words().keys;
  const rows = (group: KeyGroup) =>
    KEY_BINDINGS.filter((binding) => binding.group === group).map(
      ({ keys, meaning }) =>
        html`<dt>${keyCaps(keys)}</dt>
          <dd>${meanings[meaning]}</dd>`,
    );
  return (Object.keys(groups) as KeyGroup[]).map(
    (group) =>
      html`<h4>${groups[group]}</h4>
        <dl>${rows(group)}</dl>`,
  );
}
