// A branch's filters: add, remove, reorder, and set their parameters.
import { css, html, LitElement } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { FilterListModel, FilterModel } from '../state/filter_model.ts';
import type { JsonObject } from '../state/merge_patch.ts';
import { shared } from '../styles/shared.ts';
import './module_fields.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-filter-list')
export class FilterList extends LitElement {
  @property({ attribute: false }) model!: FilterListModel;
  @property({ attribute: false }) group = '';
  @property({ attribute: false }) change!: (patch: JsonObject) => void;

  static override styles = [
    shared,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      .filter {
        padding: 4px 10px 10px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface-raised);
      }
      .head {
        display: flex;
        align-items: center;
      }
      .head strong {
        flex: 1;
        font-weight: 600;
      }
      .additions[hidden] {
        display: none;
      }
      .additions {
        display: flex;
        flex-wrap: wrap;
        gap: 6px;
      }
      .text-button {
        display: inline-flex;
        align-items: center;
        gap: 4px;
        padding: 5px 10px;
        font-size: 13px;
      }
      .text-button wa-icon {
        font-size: 15px;
      }
    `,
  ];

  override render() {
    const { filters, additions } = this.model;
    return html`
      ${filters.map((filter) => this.filter(filter))}
      <div class="additions" ?hidden=${additions.length === 0}>
        ${additions.map((addition) => this.addition(addition))}
      </div>
    `;
  }

  private addition({ title, description, patch }: FilterListModel['additions'][number]) {
    return html`<button
      class="text-button"
      title=${description}
      aria-label="${this.group}: ${words().panel.adjust.add(title)}"
      @click=${() => this.change(patch)}
    >
      <wa-icon name="add"></wa-icon>${title}
    </button>`;
  }

  private filter(filter: FilterModel) {
    const { earlier, later_in_order, remove } = words().panel.adjust;
    return html`<div class="filter">
      <div class="head" title=${filter.description}>
        <strong>${filter.title}</strong>
        ${this.action('up', earlier(filter.title), filter.earlier)}
        ${this.action('down', later_in_order(filter.title), filter.later)}
        ${this.action('remove', remove(filter.title), filter.removed)}
      </div>
      <cutaway-module-fields
        .controls=${filter.controls}
        .group=${`${this.group}, ${filter.title}`}
        .change=${this.change}
      ></cutaway-module-fields>
    </div>`;
  }

  private action(icon: string, label: string, patch: JsonObject | undefined) {
    return html`<button
      class="icon-button"
      aria-label="${this.group}, ${label}"
      ?disabled=${patch === undefined}
      @click=${() => patch && this.change(patch)}
    >
      <wa-icon name=${icon}></wa-icon>
    </button>`;
  }
}
