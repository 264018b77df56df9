// A component that draws over one of the session's pictures.
import { property } from 'lit/decorators.js';
import type { ViewName } from '../state/views.ts';
import { SessionElement } from './session_element.ts';

export abstract class ViewElement extends SessionElement {
  @property({ attribute: false }) view: ViewName = '3d';
}
