// JPEG from planes that the renderer has already converted.
#pragma once

#include "core/picture.h"

namespace cutaway {

/// `picture` is a YCbCr one: the codec reads whole 2x2 blocks of 4:2:0, which is why its planes
/// come padded. quality 1..100. Any thread. Throws Error "internal" for RGBA and when the library
/// refuses.
JpegPicture encode_jpeg(const Picture& picture, int quality);

}  // namespace cutaway
