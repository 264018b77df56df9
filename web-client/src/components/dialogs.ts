// The dialogs, whose code comes when they are opened first.
import { html, nothing, type PropertyValues } from 'lit';
import { customElement } from 'lit/decorators.js';
import { LatePart } from './late_part.ts';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-dialogs')
export class Dialogs extends SessionElement {
  protected override readonly draws = ['help_open', 'exporting'] as const;

  private readonly help = new LatePart(this, () => import('./help_dialog.ts'));
  private readonly export = new LatePart(this, () => import('./export_dialog.ts'));

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const { toasts, commands, exporting } = this.session;
    if (this.state.help_open) void this.help.ask(toasts, () => commands.toggleHelp(false));
    if (this.state.exporting.open) void this.export.ask(toasts, () => exporting.show(false));
  }

  override render() {
    const { session } = this;
    return html`
      ${this.help.is_there ? html`<cutaway-help-dialog .session=${session}></cutaway-help-dialog>` : nothing}
      ${this.export.is_there ? html`<cutaway-export-dialog .session=${session}></cutaway-export-dialog>` : nothing}
    `;
  }
}
