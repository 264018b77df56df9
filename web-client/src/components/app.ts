// The page: bar, picture, panel, messages. Its attributes tell where it stands, for tests and for
// styling.
import { css, html, nothing, type PropertyValues } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import '@awesome.me/webawesome/dist/components/icon/icon.js';
import { shared } from '../styles/shared.ts';
import { lossInWords } from '../state/link_reason.ts';
import './dialogs.ts';
import './export_chip.ts';
import './panel.ts';
import { SessionElement } from './session_element.ts';
import './status_line.ts';
import './toast_stack.ts';
import './top_bar.ts';
import './views.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-app')
export class CutawayApp extends SessionElement {
  protected override readonly draws = [
    'link',
    'sent_input',
    'shown_input',
    'shown',
    'loading',
    'volume',
    'preferences',
    'address_current',
    'lens_follows',
    'comparing',
    'stalled',
  ] as const;

  /** Of the views, by number. */
  @property({ attribute: false }) canvases!: readonly HTMLCanvasElement[];

  static override styles = [
    shared,
    css`
      :host {
        display: grid;
        grid-template: 'bar bar' 52px 'picture panel' minmax(0, 1fr) / minmax(0, 1fr) 348px;
        height: 100dvh;
      }
      :host([data-panel='closed']) {
        grid-template-columns: minmax(0, 1fr) 0;
      }
      cutaway-top-bar {
        grid-area: bar;
      }
      main {
        grid-area: picture;
        display: grid;
        grid-template: minmax(0, 1fr) auto / minmax(0, 1fr);
        min-width: 0;
        min-height: 0;
      }
      aside {
        grid-area: panel;
        display: grid;
        min-height: 0;
        border-left: 1px solid var(--line);
      }
      :host([data-panel='closed']) aside {
        display: none;
      }
      cutaway-views,
      cutaway-export-chip,
      cutaway-toast-stack {
        grid-area: 1 / 1;
      }
      cutaway-export-chip {
        place-self: start center;
        z-index: 1;
        margin-top: 44px;
      }
      /* Above the picture's notices. */
      cutaway-toast-stack {
        place-self: end start;
        z-index: 10;
        margin: 0 16px 72px;
        width: min(400px, calc(100% - 32px));
      }
      @media (max-width: 720px) {
        :host,
        :host([data-panel='closed']) {
          grid-template: 'bar' 52px 'picture' minmax(0, 1fr) 'panel' auto / minmax(0, 1fr);
        }
        aside,
        :host([data-panel='closed']) aside {
          display: grid;
          border-left: 0;
        }
        :host([data-panel='open']) aside {
          height: min(52dvh, 460px);
        }
        cutaway-toast-stack {
          place-self: start;
          margin: 8px 16px 0;
        }
      }
    `,
  ];

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const { link, shown, loading, volume, preferences, sent_input, shown_input, address_current } =
      this.state;
    this.mark('connection', link.phase);
    this.mark('frame', shown?.frame);
    this.mark('input', shown && shown_input);
    this.mark('sent', sent_input);
    this.mark('revision', shown?.revision);
    this.mark('still', shown && String(shown.still));
    this.mark('loading', loading?.stage);
    this.mark('volume', volume?.id);
    this.mark('address', address_current ? 'current' : 'pending');
    this.mark('panel', preferences.panel_open ? 'open' : 'closed');
  }

  override render() {
    return html`
      <cutaway-top-bar role="banner" .session=${this.session}></cutaway-top-bar>
      <main>
        <cutaway-views .session=${this.session} .canvases=${this.canvases}></cutaway-views>
        ${this.state.preferences.status_line ? html`<cutaway-status-line .session=${this.session}></cutaway-status-line>` : nothing}
        <cutaway-export-chip .session=${this.session}></cutaway-export-chip>
        <cutaway-toast-stack .session=${this.session}></cutaway-toast-stack>
      </main>
      <aside aria-label=${words().page.volumes_and_settings}>
        <cutaway-panel .session=${this.session}></cutaway-panel>
      </aside>
      <cutaway-dialogs .session=${this.session}></cutaway-dialogs>
      <div class="visually-hidden" role="status">${this.announcement()}</div>
    `;
  }

  private announcement(): string {
    const { link, loading, volume, lens_follows, awaits_volume, comparing, stalled } = this.state;
    const texts = words().page;
    const loss = lossInWords(link);
    if (loss) return texts.disconnected(loss);
    if (link.phase === 'queued') return texts.queue(link.place);
    if (link.phase === 'gave_way') return texts.gave_way;
    if (stalled) return texts.stalled;
    if (loading) return texts.opening(texts.stages[loading.stage]);
    if (awaits_volume) return texts.looking_for_volumes;
    if (comparing) return texts.comparing;
    if (lens_follows) return texts.lens_follows;
    return volume ? texts.showing(volume.title) : '';
  }

  private mark(name: string, value: string | number | undefined): void {
    if (value === undefined) delete this.dataset[name];
    else this.dataset[name] = String(value);
  }
}
