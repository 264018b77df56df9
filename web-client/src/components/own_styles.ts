// The user's own styles: saved from the present look or read from a file; renamed, deleted, saved
// as a file.
import { html } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { InSight } from '../interaction/in_sight.ts';
import {
  asStyle,
  cleanTitle,
  LONGEST_TITLE,
  pictureKey,
  type OwnStyle,
} from '../state/own_styles.ts';
import { matchingStyle, stylePatch } from '../state/style_patch.ts';
import { swatchOf } from '../state/style_swatch.ts';
import { words } from '../words/words.ts';
import { shared } from '../styles/shared.ts';
import { own_styles_styles } from './own_styles_styles.ts';
import { SessionElement } from './session_element.ts';
import './style_picture.ts';

@customElement('cutaway-own-styles')
export class OwnStyles extends SessionElement {
  protected override readonly draws = ['own_styles', 'scene', 'capabilities', 'previews'] as const;

  private readonly sight = new InSight(this, () => this.askForPictures());

  @state() private title_typed = '';
  @query('input[type=file]') private chooser!: HTMLInputElement;

  static override styles = [shared, own_styles_styles];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.session.previews.want('own', []);
  }

  private askForPictures(): void {
    const { own_styles, capabilities } = this.state;
    if (!capabilities) return;
    const { names } = this.sight;
    const seen = own_styles.filter(({ title }) => names.has(title));
    const wishes = seen.map((style) => ({
      key: pictureKey(style),
      preview: { scene: { ...stylePatch(asStyle(style), capabilities.modules) } },
    }));
    this.session.previews.want('own', wishes);
  }

  override render() {
    const { own_styles, scene } = this.state;
    const worn = matchingStyle(scene, own_styles.map(asStyle))?.name;
    return html`
      <h2 id="own">${words().own_styles.heading}</h2>
      ${
        own_styles.length === 0
          ? html`<p class="quiet small">${words().own_styles.none}</p>`
          : html`<ul aria-labelledby="own">
              ${own_styles.map((style) => this.entry(style, style.title === worn))}
            </ul>`
      }
      ${this.form(own_styles)}
    `;
  }

  private entry(style: OwnStyle, worn: boolean) {
    const { capabilities, previews } = this.state;
    const { own_styling } = this.session;
    const { title } = style;
    const picture = previews.get(pictureKey(style));
    const swatch = capabilities && swatchOf(asStyle(style), capabilities.modules);
    return html`<li
      data-own-style=${title}
      data-card=${title}
      data-picture=${picture ? 'rendered' : 'drawn'}
      class=${worn ? 'worn' : ''}
    >
      <button
        class="apply"
        aria-label=${title}
        aria-pressed=${worn ? 'true' : 'false'}
        @click=${() => own_styling.apply(style)}
      >
        <cutaway-style-picture .picture=${picture} .swatch=${swatch}></cutaway-style-picture>
      </button>
      <input
        aria-label=${words().own_styles.rename(title)}
        maxlength=${LONGEST_TITLE}
        .value=${title}
        @change=${(event: Event) => this.rename(title, event.target as HTMLInputElement)}
      />
      ${this.action('save', words().own_styles.export(title), () => own_styling.exportFile(style))}
      ${this.action('remove', words().own_styles.remove(title), () => own_styling.remove(title))}
    </li>`;
  }

  private action(icon: string, label: string, action: () => void) {
    return html`<button class="icon-button" aria-label=${label} title=${label} @click=${action}>
      <wa-icon name=${icon}></wa-icon>
    </button>`;
  }

  /** What is typed outlives what else changes on the page; a name that is refused goes. */
  private rename(title: string, input: HTMLInputElement): void {
    const typed = input.value;
    input.value = title;
    this.session.own_styling.rename(title, typed);
  }

  private form(own_styles: readonly OwnStyle[]) {
    const title = cleanTitle(this.title_typed);
    const exists = own_styles.some((style) => style.title === title);
    const { name, save, replace } = words().own_styles;
    return html`<form @submit=${this.save}>
        <input
          name="title"
          aria-label=${name}
          placeholder=${name}
          maxlength=${LONGEST_TITLE}
          autocomplete="off"
          .value=${live(this.title_typed)}
          @input=${(event: Event) => (this.title_typed = (event.target as HTMLInputElement).value)}
        />
        <button class="text-button" ?disabled=${!title || !this.state.scene}>
          ${exists ? replace : save}
        </button>
      </form>
      <input
        type="file"
        accept=".json,application/json"
        aria-label=${words().own_styles.import}
        tabindex="-1"
        hidden
        @change=${this.import}
      />
      <button class="text-button import" @click=${() => this.chooser.click()}>
        ${words().own_styles.import}
      </button>`;
  }

  private save(event: Event): void {
    event.preventDefault();
    this.session.own_styling.save(this.title_typed);
    this.title_typed = '';
  }

  private import(): void {
    for (const file of this.chooser.files ?? []) void this.session.own_styling.importFile(file);
    // The same file may be chosen once more.
    this.chooser.value = '';
  }
}
