// Lossless stills.
#pragma once

#include "core/picture.h"

namespace cutaway {

/// `picture` is RGBA; alpha is dropped. Any thread. Throws Error "internal" for any other layout
/// and when the library refuses.
PngPicture encode_png(const Picture& picture);

}  // namespace cutaway
