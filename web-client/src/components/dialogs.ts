// The dialogs, whose code comes when they are opened first.
import { html, nothing, type PropertyValues } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { SessionElement } from './session_element.ts';

@customElement('cutaway-dialogs')
export class Dialogs extends SessionElement {
  protected override readonly draws = ['help_open', 'exporting'] as const;

  @state() private help_loaded = false;
  @state() private export_loaded = false;

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.state.help_open && !this.help_loaded) void this.loadHelp();
    if (this.state.exporting.open && !this.export_loaded) void this.loadExport();
  }

  private async loadHelp(): Promise<void> {
    await import('./help_dialog.ts');
    this.help_loaded = true;
  }

  private async loadExport(): Promise<void> {
    await import('./export_dialog.ts');
    this.export_loaded = true;
  }

  override render() {
    const { session } = this;
    return html`
      ${this.help_loaded ? html`<cutaway-help-dialog .session=${session}></cutaway-help-dialog>` : nothing}
      ${this.export_loaded ? html`<cutaway-export-dialog .session=${session}></cutaway-export-dialog>` : nothing}
    `;
  }
}
