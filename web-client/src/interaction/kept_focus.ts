// Keeps the keyboard's focus in the page: what had it may be removed or become disabled by the very
// key that was pressed on it, and the browser would then begin anew at the top of the page.
import type { Store } from '../state/store.ts';

const FOCUSABLE = 'button, input, select, textarea, summary, a[href], [tabindex]';

const isFocusable = (element: Element): element is HTMLElement =>
  element instanceof HTMLElement &&
  element.matches(FOCUSABLE) &&
  !element.matches(':disabled') &&
  element.tabIndex >= 0 &&
  element.checkVisibility({ visibilityProperty: true });

function childrenOf(element: Element): Iterable<Element> {
  if (element instanceof HTMLSlotElement) return element.assignedElements({ flatten: true });
  return (element.shadowRoot ?? element).children;
}

/** Those that Tab stops at, in its order, through all shadow trees. */
function* focusables(element: Element): Generator<HTMLElement> {
  if (isFocusable(element)) yield element;
  for (const child of childrenOf(element)) yield* focusables(child);
}

interface Focus {
  readonly element: Element;
  /** What it lies in, from the inside outwards. */
  readonly around: readonly Element[];
}

function focused({ activeElement }: Document): Element | undefined {
  let at = activeElement;
  while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
  return at && at !== document.body ? at : undefined;
}

function parentOf(element: Element): Element | null {
  const { assignedSlot, parentElement } = element;
  if (assignedSlot ?? parentElement) return assignedSlot ?? parentElement;
  const root = element.getRootNode();
  return root instanceof ShadowRoot ? root.host : null;
}

function around(element: Element): readonly Element[] {
  const parent = parentOf(element);
  return parent ? [parent, ...around(parent)] : [];
}

/** Where one is disabled, and still there. */
function isAfter(lost: Element, other: Element): boolean {
  const position = lost.compareDocumentPosition(other);
  const { DOCUMENT_POSITION_FOLLOWING, DOCUMENT_POSITION_DISCONNECTED } = Node;
  return Boolean(
    position & DOCUMENT_POSITION_FOLLOWING && !(position & DOCUMENT_POSITION_DISCONNECTED),
  );
}

/** In the smallest part of the page that is still there. */
function nearestTo({ element, around: parts }: Focus): HTMLElement | undefined {
  for (const part of parts.filter(({ isConnected }) => isConnected)) {
    const places = [...focusables(part)];
    if (places.length > 0) return places.find((one) => isAfter(element, one)) ?? places[0];
  }
  return undefined;
}

/** Lasts as long as the page, which is drawn anew when `store` changes. */
export function keepFocus<State extends object>(page: Document, store: Store<State>): void {
  let last: Focus | undefined;
  let waits = false;
  const look = (): void => {
    waits = false;
    const element = focused(page);
    if (!element) {
      if (last && !isFocusable(last.element)) nearestTo(last)?.focus();
    } else if (!element.matches(':focus-visible')) {
      // Shown by no ring: it came with a pointer, and nobody goes on from there by keyboard.
      last = undefined;
    } else if (element !== last?.element) last = { element, around: around(element) };
  };
  page.addEventListener('keydown', look, { capture: true });
  store.subscribe(() => {
    if (!waits) requestAnimationFrame(look);
    waits = true;
  });
}
