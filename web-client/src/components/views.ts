// The session's pictures side by side, and what lies over all of them. The 3-D picture is always
// there, if hidden; a slice that is not shown is no element, and the server makes none of it.
import { css, html, type PropertyValues } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { repeat } from 'lit/directives/repeat.js';
import { viewChoice } from '../state/slice_views.ts';
import { loneView, showsSlices, viewNumber, visibleViews, type ViewName } from '../state/views.ts';
import { SLICE_NAMES, type SliceName } from '../view/slice_geometry.ts';
import { shared } from '../styles/shared.ts';
import { LatePart } from './late_part.ts';
import './loading_card.ts';
import './measure_readout.ts';
import './measure_toolbar.ts';
import './picture_messages.ts';
import { SessionElement } from './session_element.ts';
import './viewport.ts';

@customElement('cutaway-views')
export class CutawayViews extends SessionElement {
  protected override readonly draws = ['preferences', 'maximised'] as const;

  /** Of the views, by number. */
  @property({ attribute: false }) canvases!: readonly HTMLCanvasElement[];

  private readonly slice_views = new LatePart(this, () => import('./slice_view.ts'));

  private had_focus = false;

  static override styles = [
    shared,
    css`
      :host {
        position: relative;
        display: block;
        overflow: hidden;
        background: var(--page);
      }
      .views {
        position: absolute;
        inset: 0;
        display: grid;
        gap: 2px;
        grid-template: minmax(0, 1fr) / minmax(0, 1fr);
        background: var(--line);
      }
      /* Beside the button that enlarges a view. */
      .views:not(.lone) {
        --cube-inset: 40px;
      }
      .views.grid {
        grid-template: repeat(2, minmax(0, 1fr)) / repeat(2, minmax(0, 1fr));
      }
      .views.focus {
        grid-template: repeat(3, minmax(0, 1fr)) / minmax(0, 1fr) minmax(170px, 27%);
        grid-auto-flow: column;
      }
      .views.focus .large {
        grid-area: 1 / 1 / -1 / 2;
      }
      .views.focus .small {
        grid-column: 2;
      }
      /* The tools lie over the first of them. */
      .views:not(.grid, .focus) > *,
      .views.grid cutaway-viewport,
      .views.focus .large {
        --left-letter-inset: 70px;
      }
      [hidden] {
        display: none;
      }
      @media (max-width: 720px) {
        .views.focus {
          grid-template: minmax(0, 1fr) minmax(110px, 26%) / repeat(3, minmax(0, 1fr));
          grid-auto-flow: row;
        }
        .views.focus .large {
          grid-area: 1 / 1 / 2 / -1;
        }
        .views.focus .small {
          grid-column: auto;
          grid-row: 2;
        }
      }
    `,
  ];

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (showsSlices(viewChoice(this.state))) void this.loadSlices();
    this.had_focus = this.matches(':focus-within');
  }

  /** The view that had the focus may be gone: another one has it, or keys would mean nothing. */
  override updated(): void {
    if (!this.had_focus || this.matches(':focus-within')) return;
    this.renderRoot
      .querySelector<HTMLElement>('cutaway-viewport:not([hidden]), cutaway-slice-view')
      ?.focus();
  }

  private loadSlices(): Promise<void> {
    const { toasts, layout } = this.session;
    return this.slice_views.ask(toasts, () => layout.choose('single'));
  }

  override render() {
    const choice = viewChoice(this.state);
    const lone = loneView(choice);
    const visible = visibleViews(choice);
    const slices = SLICE_NAMES.filter(
      (name) => this.slice_views.is_there && visible.includes(name),
    );
    const kind = (name: ViewName): string => (name === choice.main_view ? 'large' : 'small');
    const [volume] = this.canvases;
    return html`
      <div
        class="views ${classMap({ [choice.layout]: !lone, lone: lone === '3d' && !choice.maximised })}"
        data-part="views"
        data-layout=${lone ?? choice.layout}
      >
        <cutaway-viewport
          class=${kind('3d')}
          ?hidden=${!visible.includes('3d')}
          .session=${this.session}
          .canvas=${volume}
        ></cutaway-viewport>
        ${repeat(
          slices,
          (name) => name,
          (name) => this.slice(name, kind(name)),
        )}
      </div>
      <cutaway-measure-toolbar .session=${this.session}></cutaway-measure-toolbar>
      <cutaway-measure-readout .session=${this.session}></cutaway-measure-readout>
      <cutaway-picture-messages .session=${this.session}></cutaway-picture-messages>
      <cutaway-loading-card .session=${this.session}></cutaway-loading-card>
    `;
  }

  private slice(name: SliceName, kind: string) {
    return html`<cutaway-slice-view
      class=${kind}
      data-slice=${name}
      .session=${this.session}
      .slice=${name}
      .canvas=${this.canvases[viewNumber(name)]}
    ></cutaway-slice-view>`;
  }
}
