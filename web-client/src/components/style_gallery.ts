// The named styles, each with a picture of the user's own volume. Pictures are asked for only of
// the cards that can be seen.
import { css, html, nothing } from 'lit';
import { customElement } from 'lit/decorators.js';
import { InSight } from '../interaction/in_sight.ts';
import { observeViewport } from '../interaction/viewport_size.ts';
import type { CapabilitiesMessage, Style } from '../protocol/messages.ts';
import { previewSize } from '../state/preview_subject.ts';
import { groupOf, stylesOf } from '../state/style_groups.ts';
import { asStyle } from '../state/own_styles.ts';
import { matchingStyle } from '../state/style_patch.ts';
import { swatchOf } from '../state/style_swatch.ts';
import { card_look } from '../styles/card.ts';
import { shared } from '../styles/shared.ts';
import './compare_button.ts';
import './detail_sliders.ts';
import './own_styles.ts';
import './section.ts';
import { SessionElement } from './session_element.ts';
import './style_picture.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-style-gallery')
export class StyleGallery extends SessionElement {
  protected override readonly draws = ['capabilities', 'scene', 'previews', 'own_styles'] as const;

  private readonly sight = new InSight(this, () => this.askForPictures());
  private measured: Element | undefined;
  private measure: ResizeObserver | undefined;
  /** Opens by itself when a study is worn, and then stays as the user leaves it. */
  private studies_open = false;

  static override styles = [
    shared,
    css`
      h2 {
        margin: 0 2px 10px;
        font-size: 14px;
        font-weight: 600;
      }
      .worn {
        min-height: 3.7em;
        margin: 0 2px 12px;
        overflow: hidden;
      }
      .worn strong {
        color: var(--text);
        font-weight: 600;
      }
      ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(136px, 1fr));
        gap: 10px;
      }
      cutaway-section {
        margin-top: 14px;
        border-top: 1px solid var(--line);
      }
      button {
        display: flex;
        flex-direction: column;
        height: 100%;
        ${card_look}
      }
      button:hover {
        border-color: var(--line-strong);
        background: var(--surface-hover);
      }
      button[aria-pressed='true'] {
        border-color: var(--accent);
        box-shadow: 0 0 0 1px var(--accent);
      }
      .title {
        display: block;
        padding: 6px 9px 8px;
        font-size: 13px;
        font-weight: 550;
        line-height: 1.3;
      }
    `,
  ];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.measure?.disconnect();
    this.session.previews.want('served', []);
  }

  override updated(): void {
    const first = this.renderRoot.querySelector('cutaway-style-picture') ?? undefined;
    if (first !== this.measured) this.measureAnew(first);
  }

  private measureAnew(picture: Element | undefined): void {
    this.measured = picture;
    this.measure?.disconnect();
    const { previews } = this.session;
    this.measure =
      picture && observeViewport(picture, (size) => previews.resize(previewSize(size)));
  }

  private askForPictures(): void {
    const { names } = this.sight;
    const seen = this.state.capabilities?.styles.filter(({ name }) => names.has(name)) ?? [];
    const wishes = seen.map(({ name }) => ({ key: name, preview: { style: name } }));
    this.session.previews.want('served', wishes);
  }

  override render() {
    const { capabilities, scene } = this.state;
    if (!capabilities) return html`<p class="quiet">${words().panel.styles.waiting}</p>`;
    const worn = matchingStyle(scene, capabilities.styles);
    const studies = stylesOf('study', capabilities.styles);
    this.studies_open ||= groupOf(worn) === 'study';
    return html`${this.caption(worn)}
      <cutaway-compare-button .session=${this.session}></cutaway-compare-button>
      <cutaway-detail-sliders .session=${this.session}></cutaway-detail-sliders>
      <h2 id="illustrations">${words().panel.styles.illustrations}</h2>
      ${this.cards('illustrations', stylesOf('illustration', capabilities.styles), worn)}
      ${
        studies.length === 0
          ? nothing
          : html`<cutaway-section
              heading=${words().panel.styles.studies}
              hint=${studies.length}
              ?open=${this.studies_open}
            >
              ${this.cards('', studies, worn)}
            </cutaway-section>`
      }
      <cutaway-own-styles .session=${this.session}></cutaway-own-styles>`;
  }

  private caption(worn: Style | undefined) {
    const { own_look, own_look_hint } = words().panel.styles;
    const own = worn
      ? undefined
      : matchingStyle(this.state.scene, this.state.own_styles.map(asStyle));
    return html`<p class="worn quiet small">
      ${
        worn
          ? html`<strong>${worn.title}.</strong> ${worn.description}`
          : own
            ? html`<strong>${own.title}.</strong> ${words().own_styles.hint}`
            : html`<strong>${own_look}</strong> ${own_look_hint}`
      }
    </p>`;
  }

  private cards(heading: string, styles: readonly Style[], worn: Style | undefined) {
    const { capabilities } = this.state;
    return html`<ul aria-labelledby=${heading || nothing}>
      ${styles.map((style) => capabilities && this.card(style, style === worn, capabilities))}
    </ul>`;
  }

  private card(style: Style, worn: boolean, { modules }: CapabilitiesMessage) {
    const picture = this.state.previews.get(style.name);
    return html`<li data-card=${style.name}>
      <button
        aria-pressed=${worn ? 'true' : 'false'}
        aria-description=${style.description}
        title=${style.description}
        data-style=${style.name}
        data-picture=${picture ? 'rendered' : 'drawn'}
        @click=${() => this.session.commands.applyStyle(style)}
      >
        <cutaway-style-picture
          .picture=${picture}
          .swatch=${picture ? undefined : swatchOf(style, modules)}
        ></cutaway-style-picture>
        <span class="title">${style.title}</span>
      </button>
    </li>`;
  }
}
