// The header before every picture; protocol/README.md, "Binary messages".

export interface FrameHeader {
  readonly type: 'live' | 'saved_still' | 'preview';
  readonly still: boolean;
  readonly lossless: boolean;
  /** Which of the session's pictures: 0 in 3-D, 1 axial, 2 coronal, 3 sagittal. */
  readonly view: number;
  /** For a saved still or a preview, its request. */
  readonly frame: number;
  readonly revision: number;
  readonly input: number;
  readonly clock_ms: number;
  readonly render_us: number;
  readonly encode_us: number;
  readonly width_px: number;
  readonly height_px: number;
  readonly viewport_width_px: number;
  readonly viewport_height_px: number;
}

export interface FrameMessage {
  readonly header: FrameHeader;
  readonly picture: Uint8Array<ArrayBuffer>;
}

export class FrameHeaderError extends Error {}

const MAGIC = 0x46575443;
const KNOWN_LENGTH = 56;
const TYPES: Readonly<Record<number, FrameHeader['type']>> = {
  1: 'live',
  2: 'saved_still',
  3: 'preview',
};

function checkStart(view: DataView): void {
  if (view.byteLength < KNOWN_LENGTH) {
    throw new FrameHeaderError(
      `a frame of ${view.byteLength} bytes is shorter than its ${KNOWN_LENGTH}-byte header`,
    );
  }
  const magic = view.getUint32(0, true);
  if (magic !== MAGIC) throw new FrameHeaderError(`unknown frame magic 0x${magic.toString(16)}`);
}

/** A later header version may be longer, never shorter. */
function headerLength(view: DataView): number {
  const length = view.getUint16(8, true);
  if (length < KNOWN_LENGTH || length > view.byteLength) {
    throw new FrameHeaderError(
      `frame header version ${view.getUint8(4)} announces ${length} bytes`,
    );
  }
  return length;
}

function frameType(view: DataView): FrameHeader['type'] {
  const number = view.getUint8(5);
  const type = TYPES[number];
  if (!type) throw new FrameHeaderError(`unknown frame type ${number}`);
  return type;
}

function readHeader(view: DataView): FrameHeader {
  const flags = view.getUint8(6);
  return {
    type: frameType(view),
    still: (flags & 1) !== 0,
    lossless: (flags & 2) !== 0,
    view: view.getUint16(10, true),
    frame: view.getUint32(12, true),
    revision: view.getUint32(16, true),
    input: view.getUint32(20, true),
    clock_ms: view.getFloat64(24, true),
    render_us: view.getUint32(32, true),
    encode_us: view.getUint32(36, true),
    width_px: view.getUint16(40, true),
    height_px: view.getUint16(42, true),
    viewport_width_px: view.getUint16(44, true),
    viewport_height_px: view.getUint16(46, true),
  };
}

/** Throws FrameHeaderError where the message is not a whole frame. */
export function decodeFrame(message: ArrayBuffer): FrameMessage {
  const view = new DataView(message);
  checkStart(view);
  const picture_start = headerLength(view);
  const picture_bytes = view.getUint32(48, true);
  if (picture_start + picture_bytes > message.byteLength) {
    const came = message.byteLength - picture_start;
    throw new FrameHeaderError(`a picture of ${picture_bytes} bytes was announced, ${came} came`);
  }
  return {
    header: readHeader(view),
    picture: new Uint8Array(message, picture_start, picture_bytes),
  };
}
