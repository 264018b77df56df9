// What has to be said over the pictures: that there is none yet, or no connection, that another
// style is shown for comparison, or why nothing is to be seen.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { lossInWords } from '../state/link_reason.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-picture-messages')
export class PictureMessages extends SessionElement {
  protected override readonly draws = [
    'link',
    'shown',
    'loading',
    'volumes',
    'awaits_volume',
    'capabilities',
    'comparing',
    'stalled',
    'unseen',
  ] as const;

  static override styles = [
    shared,
    css`
      :host {
        position: absolute;
        inset: 0;
        pointer-events: none;
      }
      .banner {
        position: absolute;
        top: 44px;
        left: 50%;
        transform: translateX(-50%);
        display: flex;
        gap: 12px;
        align-items: center;
        width: max-content;
        max-width: calc(100% - 32px);
        padding: 10px 14px;
        border: 1px solid var(--line-strong);
        border-radius: var(--radius);
        background: var(--surface-floating);
        box-shadow: var(--shadow);
        pointer-events: auto;
      }
      .quiet {
        pointer-events: none;
      }
      .chip {
        position: absolute;
        top: 44px;
        left: 50%;
        transform: translateX(-50%);
        padding: 6px 14px;
        border-radius: 999px;
        background: var(--on-picture-accent);
        color: var(--on-picture-on-accent);
        font-weight: 600;
      }
      .empty {
        position: absolute;
        inset: 0;
        display: grid;
        place-content: center;
        justify-items: center;
        gap: 6px;
        padding: 24px;
        text-align: center;
        color: var(--text-quiet);
      }
    `,
  ];

  override render() {
    const over_the_top = this.offlineBanner() ?? this.comparison() ?? this.unseen();
    return html`${this.emptyNote()} ${over_the_top ?? nothing}`;
  }

  private emptyNote() {
    const { shown, loading, link, capabilities, volumes, awaits_volume } = this.state;
    const is_told = link.phase === 'queued' || link.phase === 'gave_way' || lossInWords(link);
    if (shown || loading || is_told) return nothing;
    const texts = words().page;
    const empty = capabilities !== undefined && volumes.length === 0;
    const coming = awaits_volume ? texts.looking_for_volumes : texts.preparing;
    const waiting = link.phase === 'connecting' ? texts.connecting : coming;
    const text = empty ? texts.no_volumes : waiting;
    return html`<div class="empty">${text}</div>`;
  }

  /** That nothing is to be seen is a word beside the picture, and in no one's way. */
  private unseen() {
    const { unseen, volume, loading } = this.state;
    if (unseen.length === 0 || !volume || loading) return undefined;
    const sentences = unseen.map((reason) => words().unseen[reason.code](reason));
    return html`<div class="banner quiet" data-part="unseen" role="status">
      <span>${sentences.join(' ')}</span>
    </div>`;
  }

  private comparison() {
    if (!this.state.comparing) return undefined;
    return html`<div class="chip" data-part="comparing">${words().page.comparing}</div>`;
  }

  private offlineBanner() {
    const { link } = this.state;
    const texts = words().page;
    if (link.phase === 'queued')
      return html`<div class="banner"><span>${texts.queue(link.place)}</span></div>`;
    if (link.phase === 'gave_way') return this.banner('gave-way', texts.gave_way, texts.go_on);
    const loss = lossInWords(link);
    if (loss) return this.banner('reconnecting', texts.reconnecting(loss));
    const stalls = link.phase === 'connected' && this.state.stalled;
    return stalls ? this.banner('stalled', texts.stalled) : undefined;
  }

  private banner(part: string, text: string, action = words().page.try_now) {
    return html`<div class="banner" data-part=${part}>
      <span>${text}</span>
      <button class="text-button" @click=${() => this.session.commands.connectNow()}>
        ${action}
      </button>
    </div>`;
  }
}
