// A scene or style document from a file that anyone may have written.
#pragma once

#include <filesystem>

#include "scene/json.h"

namespace cutaway {

/// The checked scene document of the file; a style's is the scene in it. Throws Error whose field
/// is the file, and where in it, as "FILE#/lens/radius_mm".
Json read_scene_file(const std::filesystem::path& file);

}  // namespace cutaway
