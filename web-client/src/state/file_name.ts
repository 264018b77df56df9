// Names of files that the page saves.

/** Letters and digits of any script, and single spaces; what a file system minds is gone. */
export function fileName(title: string, extension: string): string {
  return `${title.replaceAll(/[^\p{L}\p{N}]+/gu, ' ').trim()}.${extension}`;
}
