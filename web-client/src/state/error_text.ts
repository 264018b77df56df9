// An error of the server in words for the user.
import type { ErrorMessage } from '../protocol/messages.ts';
import { words } from '../words/words.ts';

export function errorDetail(error: ErrorMessage): string {
  const parts = [error.message.replace(/\.?$/, '.')];
  const { field, expected, received } = words().messages;
  if (error.field) parts.push(field(error.field));
  if (error.expected) parts.push(expected(error.expected));
  if (error.received) parts.push(received(error.received));
  return parts.join(' ');
}

export function errorTitle(error: ErrorMessage): string {
  const { error_titles, refused_change } = words().messages;
  return error_titles[error.code] ?? refused_change;
}
