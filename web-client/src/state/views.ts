// The session's pictures and how the page lays them out.
import { SLICE_NAMES } from '../view/slice_geometry.ts';

/** In the order of their numbers on the wire. */
export const VIEW_NAMES = ['3d', ...SLICE_NAMES] as const;
export type ViewName = (typeof VIEW_NAMES)[number];

export const viewNumber = (name: ViewName): number => VIEW_NAMES.indexOf(name);

/** `single`: one alone; `grid`: all four alike; `focus`: one large, three small. */
export const LAYOUTS = ['single', 'grid', 'focus'] as const;
export type Layout = (typeof LAYOUTS)[number];

export interface ViewChoice {
  readonly layout: Layout;
  /** The one that is alone, or large. */
  readonly main_view: ViewName;
  /** Has the page for itself for a while. */
  readonly maximised: ViewName | undefined;
}

/** The one view that is shown alone, if any. */
export function loneView({ layout, main_view, maximised }: ViewChoice): ViewName | undefined {
  return maximised ?? (layout === 'single' ? main_view : undefined);
}

/** The one that is alone or large, or else the volume. */
export const chiefView = (choice: ViewChoice): ViewName =>
  loneView(choice) ?? (choice.layout === 'focus' ? choice.main_view : '3d');

/** In the order in which they are shown. */
export function visibleViews(choice: ViewChoice): readonly ViewName[] {
  const lone = loneView(choice);
  if (lone) return [lone];
  if (choice.layout === 'grid') return VIEW_NAMES;
  return [choice.main_view, ...VIEW_NAMES.filter((name) => name !== choice.main_view)];
}

export const showsSlices = (choice: ViewChoice): boolean =>
  visibleViews(choice).some((name) => name !== '3d');

/** Of views that lie side by side: not the large one, but one of the small. */
const isSmall = ({ layout, main_view }: ViewChoice, name: ViewName): boolean =>
  layout === 'focus' && main_view !== name;

/** What enlarging a view, or taking that back, makes of the choice. */
export function enlarged(choice: ViewChoice, name: ViewName): ViewChoice {
  if (choice.maximised) return { ...choice, maximised: undefined };
  if (choice.layout === 'single') return { ...choice, layout: 'focus', main_view: name };
  if (isSmall(choice, name)) return { ...choice, main_view: name };
  return { ...choice, maximised: name };
}

/** The layouts one after the other; one alone is the volume again. */
export function nextLayout({ layout, maximised }: ViewChoice): Layout {
  if (maximised) return layout;
  return LAYOUTS[(LAYOUTS.indexOf(layout) + 1) % LAYOUTS.length] ?? 'single';
}
