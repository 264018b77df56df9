// How the page itself speaks and looks; remembered for the next visit.
import { html } from 'lit';
import { customElement } from 'lit/decorators.js';
import type { Choice, Control } from '../state/controls.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import './control_field.ts';
import './section.ts';
import { SessionElement } from './session_element.ts';

/** Each by its own name, so that whoever reads no other finds it. */
const LANGUAGE_NAMES: readonly Choice[] = [
  { value: 'en', label: 'English' },
  { value: 'de', label: 'Deutsch' },
];

@customElement('cutaway-page-settings')
export class PageSettings extends SessionElement {
  protected override readonly draws = ['preferences'] as const;

  static override styles = shared;

  private readonly change = (patch: JsonObject): void => this.session.commands.prefer(patch);

  override render() {
    const { settings } = words().panel;
    const languages = [{ value: 'auto', label: settings.as_browser }, ...LANGUAGE_NAMES];
    const themes = Object.entries(settings.themes).map(([value, label]) => ({ value, label }));
    return html`<cutaway-section heading=${settings.heading} open>
      ${this.choice('language', settings.language, languages)}
      ${this.choice('theme', settings.theme, themes)} ${this.statusLine()}
    </cutaway-section>`;
  }

  private statusLine() {
    const control: Control = {
      kind: 'boolean',
      id: 'page-status-line',
      label: words().panel.settings.status_line,
      description: '',
      value: this.state.preferences.status_line,
      toPatch: (status_line) => ({ status_line }),
    };
    return html`<cutaway-control .control=${control} .change=${this.change}></cutaway-control>`;
  }

  private choice(name: 'language' | 'theme', label: string, choices: readonly Choice[]) {
    const control: Control = {
      kind: 'choice',
      id: `page-${name}`,
      label,
      description: '',
      value: this.state.preferences[name],
      choices,
      toPatch: (value) => ({ [name]: value }),
    };
    return html`<cutaway-control .control=${control} .change=${this.change}></cutaway-control>`;
  }
}
