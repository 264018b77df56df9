// Whether exported pictures have their labels drawn on them, and where the notice is.
import { css, html, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { Control } from '../state/controls.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import './control_field.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-export-labels')
export class ExportLabels extends SessionElement {
  protected override readonly draws = ['capabilities', 'preferences'] as const;

  @property() what: 'picture' | 'film' = 'picture';

  static override styles = [
    shared,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
    `,
  ];

  private readonly change = (patch: JsonObject): void => this.session.commands.prefer(patch);

  override render() {
    const { capabilities, preferences } = this.state;
    if (!capabilities) return nothing;
    const { labels: label, labels_hint: description } = words().export;
    const control: Control = {
      kind: 'boolean',
      id: `export-${this.what}-labels`,
      label,
      description,
      value: preferences.picture_labels,
      toPatch: (picture_labels) => ({ picture_labels }),
    };
    return html`<cutaway-control .control=${control} .change=${this.change}></cutaway-control>
      <p class="quiet small">${this.note(capabilities.notice)}</p>`;
  }

  private note(notice: string): string {
    const { picture_note, bare_picture_note, film_note, bare_film_note } = words().export;
    const notes = {
      picture: { labelled: picture_note, bare: bare_picture_note },
      film: { labelled: film_note, bare: bare_film_note },
    };
    return notes[this.what][this.state.preferences.picture_labels ? 'labelled' : 'bare'](notice);
  }
}
