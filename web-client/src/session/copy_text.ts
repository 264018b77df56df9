// Text into the clipboard, from inside of a user's gesture.

const asBlob = async (text: Promise<string>): Promise<Blob> =>
  new Blob([await text], { type: 'text/plain' });

/**
 * To be called without a wait before it: WebKit takes a gesture for over once something is waited
 * for, so the clipboard is handed the promise. Fails where the browser does not let the page.
 */
export async function copyText(text: Promise<string>): Promise<void> {
  if (!('ClipboardItem' in globalThis)) return navigator.clipboard.writeText(await text);
  await navigator.clipboard.write([new ClipboardItem({ 'text/plain': asBlob(text) })]);
}
