// An error of the server in words for the user.
import type { ErrorMessage } from '../protocol/messages.ts';

export function errorDetail(error: ErrorMessage): string {
  const parts = [error.message.replace(/\.?$/, '.')];
  if (error.field) parts.push(`Field: ${error.field}.`);
  if (error.expected) parts.push(`Expected: ${error.expected}.`);
  if (error.received) parts.push(`Received: ${error.received}.`);
  return parts.join(' ');
}

const TITLES: Partial<Record<ErrorMessage['code'], string>> = {
  'unknown-volume': 'This volume is not on the server',
  'volume-refused': 'The volume could not be opened',
  'no-volume': 'No volume is open',
  'server-full': 'The server is full',
  'render-failed': 'The picture could not be rendered',
  'rate-limited': 'Too many requests',
  'too-large': 'Too large for this server',
  internal: 'The server made a mistake',
};

export function errorTitle(error: ErrorMessage): string {
  return TITLES[error.code] ?? 'The server refused a change';
}
