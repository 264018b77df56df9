// The panel: beside the picture on a wide page, a sheet from below on a phone. Its tabs stay when
// it is closed there.
import { css, html, nothing, type PropertyValues } from 'lit';
import { customElement } from 'lit/decorators.js';
import { keyed } from 'lit/directives/keyed.js';
import type { PanelTab } from '../state/viewer_state.ts';
import { shared } from '../styles/shared.ts';
import { afterFirstPicture, LatePart } from './late_part.ts';
import { isPhone } from './phone.ts';
import { SessionElement } from './session_element.ts';
import './style_gallery.ts';
import './volume_list.ts';
import { words } from '../words/words.ts';

const TABS: readonly PanelTab[] = ['volumes', 'styles', 'adjust', 'measure', 'view'];

@customElement('cutaway-panel')
export class CutawayPanel extends SessionElement {
  protected override readonly draws = ['panel_tab', 'preferences'] as const;

  private readonly controls = new LatePart(this, () => import('./controls.ts'));
  private readonly late_tabs: Partial<Readonly<Record<PanelTab, LatePart>>> = {
    adjust: this.controls,
    measure: new LatePart(this, () => import('./measure_tab.ts')),
    view: this.controls,
  };

  static override styles = [
    shared,
    css`
      :host {
        display: flex;
        flex-direction: column;
        min-height: 0;
        background: var(--surface);
      }
      [role='tablist'] {
        display: grid;
        grid-template-columns: repeat(5, 1fr);
        flex: none;
        border-bottom: 1px solid var(--line);
      }
      [role='tab'] {
        position: relative;
        display: grid;
        justify-items: center;
        gap: 2px;
        padding: 8px 0 7px;
        border: 0;
        background: transparent;
        color: var(--text-quiet);
        font-size: 12px;
      }
      [role='tab']:focus-visible {
        outline-offset: -3px;
      }
      [role='tab'][aria-selected='true'] {
        color: var(--text);
      }
      [role='tab'][aria-selected='true']::after {
        content: '';
        position: absolute;
        inset: auto 20% -1px;
        height: 2px;
        border-radius: 1px;
        background: var(--accent);
      }
      /* Text that is only read out lies absolutely, and would otherwise lengthen the page. */
      [role='tabpanel'] {
        position: relative;
        flex: 1;
        min-height: 0;
        padding: 14px;
        overflow: auto;
        overscroll-behavior: contain;
        scrollbar-width: thin;
        scrollbar-color: var(--line-strong) transparent;
      }
      .adjust,
      .view {
        padding-top: 2px;
      }
      @media (max-width: 720px) {
        :host {
          flex-direction: column-reverse;
        }
        [role='tablist'] {
          border-top: 1px solid var(--line);
          border-bottom: 0;
          padding-bottom: env(safe-area-inset-bottom);
        }
        [role='tab'] {
          min-height: 56px;
          align-content: center;
        }
        [role='tab'][aria-selected='true']::after {
          inset: -1px 20% auto;
        }
        [role='tabpanel'] {
          border-top: 1px solid var(--line);
        }
      }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    afterFirstPicture(this.session.store, () => void this.controls.foresee());
  }

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const { panel_tab, preferences } = this.state;
    const { toasts, commands } = this.session;
    const part = preferences.panel_open ? this.late_tabs[panel_tab] : undefined;
    void part?.ask(toasts, () => commands.showTab('styles'));
  }

  override render() {
    const { panel_tab, preferences } = this.state;
    return html`
      <div role="tablist" aria-label=${words().panel.name} @keydown=${this.onKey}>
        ${TABS.map((tab) => this.tab(tab))}
      </div>
      ${preferences.panel_open ? this.tabPanel(panel_tab) : nothing}
    `;
  }

  /** A new element for each tab, which begins at its top. */
  private tabPanel(panel_tab: PanelTab) {
    return keyed(
      panel_tab,
      html`<div
        role="tabpanel"
        class=${panel_tab}
        id="tabpanel"
        aria-labelledby="tab-${panel_tab}"
        tabindex="-1"
      >
        ${this.content(panel_tab)}
      </div>`,
    );
  }

  private tab(tab: PanelTab) {
    const { panel_tab, preferences } = this.state;
    const chosen = panel_tab === tab;
    return html`<button
      role="tab"
      id="tab-${tab}"
      aria-selected=${chosen && preferences.panel_open ? 'true' : 'false'}
      tabindex=${chosen ? '0' : '-1'}
      @click=${() => this.choose(tab)}
    >
      <wa-icon name=${tab}></wa-icon>${words().panel.tabs[tab]}
    </button>`;
  }

  /** On a phone the chosen tab again closes the sheet. */
  private choose(tab: PanelTab): void {
    const { panel_tab, preferences } = this.state;
    if (isPhone() && preferences.panel_open && panel_tab === tab)
      this.session.commands.togglePanel();
    else this.session.commands.showTab(tab);
  }

  private onKey(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const index = TABS.indexOf(this.state.panel_tab);
    const next = TABS[(index + step + TABS.length) % TABS.length];
    if (!next) return;
    this.session.commands.showTab(next);
    void this.updateComplete.then(() =>
      this.renderRoot.querySelector<HTMLElement>(`#tab-${next}`)?.focus(),
    );
  }

  private content(tab: PanelTab) {
    if (this.late_tabs[tab]?.is_there === false)
      return html`<p class="quiet">${words().panel.styles.waiting}</p>`;
    switch (tab) {
      case 'volumes':
        return html`<cutaway-volume-list .session=${this.session}></cutaway-volume-list>`;
      case 'styles':
        return html`<cutaway-style-gallery .session=${this.session}></cutaway-style-gallery>`;
      case 'adjust':
        return html`<cutaway-adjust-tab .session=${this.session}></cutaway-adjust-tab>`;
      case 'measure':
        return html`<cutaway-measure-tab .session=${this.session}></cutaway-measure-tab>`;
      case 'view':
        return html`<cutaway-view-tab .session=${this.session}></cutaway-view-tab>`;
    }
  }
}
