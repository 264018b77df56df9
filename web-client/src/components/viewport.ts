// The picture and what lies over it.
import { css, html, nothing } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { applyKey } from '../interaction/keyboard.ts';
import { followWithLens } from '../interaction/lens_follow.ts';
import { placeWithPointer, SLIP_CSS_PX } from '../interaction/placing.ts';
import { picturePoint } from '../interaction/picture_point.ts';
import { PointerGestures } from '../interaction/pointer_gestures.ts';
import { observeViewport, withinLimits } from '../interaction/viewport_size.ts';
import { listenToWheel } from '../interaction/wheel.ts';
import { linkReason } from '../state/link_reason.ts';
import { toolInHand } from '../state/measure_state.ts';
import type { Point, Viewport } from '../view/camera.ts';
import { shared } from '../styles/shared.ts';
import './hints.ts';
import './lens_overlay.ts';
import './loading_card.ts';
import './measure_overlay.ts';
import './measure_readout.ts';
import './measure_toolbar.ts';
import './orientation_cube.ts';
import './orientation_marks.ts';
import './picture_notices.ts';
import './scale_bar.ts';
import { SessionElement } from './session_element.ts';
import { words } from '../words/words.ts';

@customElement('cutaway-viewport')
export class CutawayViewport extends SessionElement {
  protected override readonly draws = [
    'link',
    'shown',
    'loading',
    'volumes',
    'awaits_volume',
    'capabilities',
    'viewport',
    'lens_follows',
    'comparing',
    'measure',
    'stalled',
  ] as const;

  @property({ attribute: false }) canvas!: HTMLCanvasElement;
  @query('.stage') private stage!: HTMLElement;

  private observer: ResizeObserver | undefined;
  private size: Viewport | undefined;

  static override styles = [
    shared,
    css`
      :host {
        position: relative;
        display: block;
        overflow: hidden;
        background: var(--page);
      }
      .stage {
        position: absolute;
        inset: 0;
        cursor: grab;
        touch-action: none;
        user-select: none;
        -webkit-user-select: none;
      }
      .stage.follows,
      .stage.measures {
        cursor: crosshair;
      }
      .stage:active {
        cursor: grabbing;
      }
      .stage:focus-visible {
        outline-offset: -2px;
      }
      canvas {
        display: block;
        width: 100%;
        height: 100%;
        object-fit: contain;
        transition:
          opacity 200ms,
          filter 200ms;
      }
      .offline canvas {
        opacity: 0.4;
        filter: grayscale(0.6);
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
        pointer-events: none;
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
        pointer-events: none;
      }
    `,
  ];

  override firstUpdated(): void {
    const { commands, measuring } = this.session;
    const measures = (): boolean => toolInHand(this.state.measure) !== undefined;
    const device_pixels = (): number =>
      (this.size?.width_px ?? 1) / Math.max(1, this.stage.clientWidth);
    new PointerGestures(this.stage, commands, device_pixels, () => (measures() ? SLIP_CSS_PX : 0));
    placeWithPointer(this.stage, {
      active: measures,
      hovered: (event) => measuring.point(this.picturePoint(event)),
      left: () => measuring.pointAway(),
      pressed: (event) => measuring.place(this.picturePoint(event)),
    });
    listenToWheel(this, commands);
    followWithLens(this, this.stage, {
      follows: () => this.state.lens_follows && this.state.scene?.lens?.mode !== 'none',
      moved: (event) => commands.dragLens(this.picturePoint(event)),
      ended: () => commands.followPointer(false),
    });
    this.stage.addEventListener('keydown', (event) =>
      applyKey(event, this.session, device_pixels()),
    );
    this.observer = observeViewport(this.canvas, (size) => this.resized(size));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer?.disconnect();
  }

  /** The server's limits may come after the element has its size, or change with a new server. */
  override updated(): void {
    if (this.size) this.resized(this.size);
  }

  private picturePoint(event: MouseEvent): Point {
    return picturePoint(event, this, this.state.viewport);
  }

  private resized(size: Viewport): void {
    const limits = this.state.capabilities?.limits;
    const wanted = limits
      ? withinLimits(size, limits.viewport_side_px, limits.viewport_pixels)
      : size;
    this.size = wanted;
    const { viewport } = this.state;
    if (viewport?.width_px !== wanted.width_px || viewport.height_px !== wanted.height_px)
      this.session.commands.resize(wanted);
  }

  override render() {
    const { link, shown, lens_follows, measure } = this.state;
    const offline = link.phase !== 'connected' && shown !== undefined;
    return html`
      <div
        class="stage ${classMap({ offline, follows: lens_follows, measures: toolInHand(measure) !== undefined })}"
        tabindex="0"
        role="application"
        aria-label=${words().page.picture}
        aria-description=${words().page.keys_in_short}
        data-part="stage"
      >
        ${this.canvas}
      </div>
      <cutaway-lens-overlay .session=${this.session}></cutaway-lens-overlay>
      <cutaway-measure-overlay .session=${this.session}></cutaway-measure-overlay>
      <cutaway-orientation-marks .session=${this.session}></cutaway-orientation-marks>
      <cutaway-orientation-cube .session=${this.session}></cutaway-orientation-cube>
      <cutaway-hints .session=${this.session}></cutaway-hints>
      <cutaway-picture-notices .session=${this.session}></cutaway-picture-notices>
      <cutaway-scale-bar .session=${this.session}></cutaway-scale-bar>
      <cutaway-measure-toolbar .session=${this.session}></cutaway-measure-toolbar>
      <cutaway-measure-readout .session=${this.session}></cutaway-measure-readout>
      ${this.emptyNote()} ${this.offlineBanner()} ${this.comparison()}
      <cutaway-loading-card .session=${this.session}></cutaway-loading-card>
    `;
  }

  private emptyNote() {
    const { shown, loading, link, capabilities, volumes, awaits_volume } = this.state;
    if (shown || loading || link.phase === 'waiting' || link.phase === 'queued') return nothing;
    const texts = words().page;
    const empty = capabilities !== undefined && volumes.length === 0;
    const coming = awaits_volume ? texts.looking_for_volumes : texts.preparing;
    const waiting = link.phase === 'connecting' ? texts.connecting : coming;
    const text = empty ? texts.no_volumes : waiting;
    return html`<div class="empty">${text}</div>`;
  }

  private comparison() {
    if (!this.state.comparing) return nothing;
    return html`<div class="chip" data-part="comparing">${words().page.comparing}</div>`;
  }

  private offlineBanner() {
    const { link } = this.state;
    const texts = words().page;
    if (link.phase === 'queued')
      return html`<div class="banner"><span>${texts.queue(link.place)}</span></div>`;
    if (link.phase === 'connected' && this.state.stalled)
      return html`<div class="banner" data-part="stalled"><span>${texts.stalled}</span></div>`;
    if (link.phase !== 'waiting') return nothing;
    return html`<div class="banner">
      <span>${texts.reconnecting(linkReason(link))}</span>
      <button class="text-button" @click=${() => this.session.commands.connectNow()}>
        ${texts.try_now}
      </button>
    </div>`;
  }
}
