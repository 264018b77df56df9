// A picture with the header of protocol/README.md before it.

export function frameMessage(header, picture) {
  const bytes = Buffer.alloc(56);
  bytes.write('CTWF', 0, 'latin1');
  bytes.set([1, header.type ?? 1, header.flags], 4);
  bytes.writeUInt16LE(56, 8);
  bytes.writeUInt16LE(header.view ?? 0, 10);
  bytes.writeUInt32LE(header.frame, 12);
  bytes.writeUInt32LE(header.revision, 16);
  bytes.writeUInt32LE(header.input, 20);
  bytes.writeDoubleLE(header.clock_ms, 24);
  bytes.writeUInt32LE(Math.round(header.render_ms * 1000), 32);
  bytes.writeUInt16LE(header.width, 40);
  bytes.writeUInt16LE(header.height, 42);
  bytes.writeUInt16LE(header.viewport.width_px, 44);
  bytes.writeUInt16LE(header.viewport.height_px, 46);
  bytes.writeUInt32LE(picture.length, 48);
  return Buffer.concat([bytes, picture]);
}
