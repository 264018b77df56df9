// Three hints of the first visit, each where it is of use. One goes once it has been followed; all
// of them when they are sent away.
import { css, html, nothing, type PropertyValues } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { styleMap } from 'lit/directives/style-map.js';
import type { Scene } from '../protocol/messages.ts';
import { sameLook } from '../state/look.ts';
import { cameraOf } from '../state/scene_parts.ts';
import { pixelSizeMm, projectPx } from '../view/camera.ts';
import { pictureToElement } from '../view/picture_fit.ts';
import { overlay_styles } from '../styles/overlay.ts';
import { shared } from '../styles/shared.ts';
import { words } from '../words/words.ts';
import { SessionElement } from './session_element.ts';

type Hint = 'turn' | 'lens' | 'style';

const HINTS: readonly Hint[] = ['turn', 'lens', 'style'];
const NO_HOVER = '(hover: none)';

const changed = (before: unknown, now: unknown): boolean =>
  JSON.stringify(before) !== JSON.stringify(now);

@customElement('cutaway-hints')
export class Hints extends SessionElement {
  protected override readonly draws = [
    'preferences',
    'shown',
    'shown_scene',
    'scene',
    'link',
    'loading',
    'comparing',
  ] as const;

  @state() private followed: ReadonlySet<Hint> = new Set();
  private first: Scene | undefined;

  static override styles = [
    shared,
    overlay_styles,
    css`
      :host {
        overflow: hidden;
      }
      /* One below the other, so that none can cover another: below the cube, above the notices. */
      section {
        position: absolute;
        inset: 0;
        display: flex;
        flex-direction: column;
        align-items: center;
        gap: 12px;
        padding: 116px 14px 40px;
      }
      .hint {
        flex: none;
        width: max-content;
        max-width: min(300px, 100%);
        padding: 7px 12px;
        border-radius: 999px;
        background: var(--on-picture-accent);
        color: var(--on-picture-on-accent);
        font-size: 13px;
        font-weight: 550;
        line-height: 1.25;
        text-align: center;
        text-wrap: balance;
        box-shadow: var(--shadow);
        animation: appear 300ms ease-out;
      }
      .style {
        align-self: flex-end;
      }
      /* As far down and to the side as the lens' rim, as far as there is room. */
      .above {
        flex: 0 1 var(--down, 0);
      }
      .row {
        display: flex;
        width: 100%;
      }
      .row::before {
        flex: var(--across, 1) 1 0;
        content: '';
      }
      .row::after {
        flex: calc(1 - var(--across, 0)) 1 0;
        content: '';
      }
      .below {
        flex: 1 1 0;
      }
      button {
        flex: none;
        padding: 6px 16px;
        border: 1px solid rgb(255 255 255 / 55%);
        border-radius: 999px;
        background: rgb(10 13 15 / 86%);
        color: var(--on-picture-text);
        pointer-events: auto;
      }
      @keyframes appear {
        from {
          opacity: 0;
        }
      }
      @media (pointer: coarse) {
        button {
          min-height: 44px;
        }
      }
      /* Above the notices, which reach the middle there, or are broken into lines. */
      @container (max-width: 640px) {
        section {
          padding-bottom: 88px;
        }
      }
      /* No room for all of them: the panel speaks for itself. */
      @container (max-height: 400px) {
        section {
          gap: 8px;
          padding-top: 92px;
        }
        .style {
          display: none;
        }
      }
      @container (max-height: 280px) or (max-width: 260px) {
        .hint,
        .row {
          display: none;
        }
      }
    `,
  ];

  private get wanted(): boolean {
    const { preferences, shown, link, loading, comparing } = this.state;
    const shows = shown !== undefined && link.phase === 'connected' && !loading && !comparing;
    return shows && !preferences.hints_seen;
  }

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const { scene } = this.state;
    if (!this.wanted || !scene?.camera || !scene.lens?.centre_mm) return;
    if (this.first?.volume !== scene.volume) this.first = scene;
    this.follow(this.first ?? scene, scene);
  }

  private follow(first: Scene, scene: Scene): void {
    const done: Readonly<Record<Hint, boolean>> = {
      turn: changed(first.camera, scene.camera),
      lens: changed(first.lens?.centre_mm, scene.lens?.centre_mm),
      style: !sameLook(scene, first),
    };
    const now = HINTS.filter((hint) => done[hint] && !this.followed.has(hint));
    if (now.length === 0) return;
    this.followed = new Set([...this.followed, ...now]);
    if (this.followed.size === HINTS.length) this.sendAway();
  }

  private readonly sendAway = (): void => this.session.commands.prefer({ hints_seen: true });

  override render() {
    if (!this.wanted) return nothing;
    const { hints } = words().page;
    const touch = matchMedia(NO_HOVER).matches;
    const texts: Readonly<Record<Hint, string>> = {
      turn: touch ? hints.turn_by_touch : hints.turn,
      lens: hints.lens,
      style: hints.style,
    };
    const hint = (name: Hint) =>
      this.followed.has(name) ? nothing : html`<p class="hint ${name}">${texts[name]}</p>`;
    const place = this.lensPlace();
    return html`<section
      aria-label=${hints.name}
      data-part="hints"
      style=${styleMap({ '--across': String(place?.across ?? 0.5) })}
    >
      ${hint('style')}
      <div class="above"></div>
      ${place ? html`<div class="row">${hint('lens')}</div>` : nothing}
      <div class="below"></div>
      ${hint('turn')}
      <button @click=${this.sendAway}>${hints.got_it}</button>
    </section>`;
  }

  /** How far down the lens' hint begins follows from what is above it. */
  override updated(): void {
    const above = this.renderRoot.querySelector<HTMLElement>('.above');
    const down_css_px = (this.lensPlace()?.top ?? 0) - (above?.offsetTop ?? 0);
    above?.style.setProperty('--down', `${Math.max(0, down_css_px)}px`);
  }

  /** Under the lens' rim: CSS pixels from the top, and the share of the picture's width. */
  private lensPlace(): { readonly top: number; readonly across: number } | undefined {
    const { shown, shown_scene } = this.state;
    const camera = cameraOf(shown_scene);
    const { centre_mm, radius_mm, mode } = shown_scene?.lens ?? {};
    if (!shown || !camera || !centre_mm || !radius_mm || mode === 'none') return undefined;
    const viewport = { width_px: shown.viewport_width_px, height_px: shown.viewport_height_px };
    const centre_px = projectPx(camera, viewport, centre_mm);
    if (!centre_px) return undefined;
    const radius_px = radius_mm / pixelSizeMm(camera, viewport, centre_mm);
    const size = { width: this.clientWidth, height: this.clientHeight };
    const [left, top] = pictureToElement([centre_px[0], centre_px[1] + radius_px], viewport, size);
    const across = Math.min(1, Math.max(0, left / Math.max(1, size.width)));
    return { top, across };
  }
}
