// Messages that come and go, and what stands in them.
import type { ErrorMessage } from '../../protocol/messages.ts';

type ErrorTitles = Readonly<Partial<Record<ErrorMessage['code'], string>>>;

export const messages = {
  error_titles: {
    'unknown-volume': 'This volume is not on the server',
    'volume-refused': 'The volume could not be opened',
    'no-volume': 'No volume is open',
    'server-full': 'The server is full',
    'render-failed': 'The picture could not be rendered',
    'rate-limited': 'Too many requests',
    'too-large': 'Too large for this server',
    internal: 'The server made a mistake',
  } as ErrorTitles,
  refused_change: 'The server refused a change',
  field: (name: string) => `Field: ${name}.`,
  expected: (what: string) => `Expected: ${what}.`,
  received: (what: string) => `Received: ${what}.`,

  link_not_opened: 'This link could not be opened',
  new_view_instead: (reason: string) => `${reason}. A new view was opened instead.`,
  link_faults: {
    too_large: 'the link is larger than any scene',
    damaged: 'the link is incomplete or damaged',
    unknown_form: 'the link is of a form that this version does not know',
    no_scene: 'the link holds no scene',
  },
  view_not_restored: 'The view before the interruption could not be restored',
  restored: 'Connected again',
  restored_detail: 'The view is as it was.',
  opening_cancelled: 'Opening was cancelled',
  unexpected: 'Something unexpected came from the server',
  nothing_to_compare: 'There is no previous style to compare with yet',
  not_without_connection: 'Another volume can be opened once there is a connection again',
  part_missing: 'A part of the page could not be loaded',
  part_missing_detail: 'The server may have been renewed. Reload the page; the view is kept.',
  picture_enlarged: 'The picture is drawn smaller than this window and enlarged',
  picture_enlarged_detail: (drawn: string, place: string) =>
    `This server draws ${drawn} pixels at most for a place of ${place}.`,
  link_in_clipboard: 'The link to this view is in the clipboard',
  link_in_address_bar: 'The link to this view is in the address bar',
  picture: 'picture',
  preferences_left_out: 'Your settings for this page were left out',
  preference_faults: {
    damaged: 'They could not be read. The page starts as on a first visit.',
    other_version: 'They are of another version. The page starts as on a first visit.',
  },
  preferences_not_kept: 'This browser keeps no settings; they last until the page is closed',
  language_not_loaded: 'The texts of this language could not be loaded',
};
