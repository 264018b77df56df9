// The files of protocol/schema and server/styles inside the program; CMakeLists.txt embeds them.
#pragma once

#include "core/embedded_file.h"

namespace cutaway {

std::span<const EmbeddedFile> embedded_schemas();
std::span<const EmbeddedFile> embedded_styles();

}  // namespace cutaway
