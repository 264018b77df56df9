// Lengths of a picture said relative to its height: a module's parameter `X_per_mille` is the twin
// of its `X`, which is in pixels of the viewport. A module says one of the two, so that a style
// that says per mille looks the same in a small picture and in a large one.
#pragma once

#include <string>

#include "scene/json.h"
#include "scene/scene.h"

namespace cutaway {

/// The other name of the length `name`, of which a module says one.
std::string per_mille_name(const std::string& name);

/// Whether a parameter of that name is a length relative to the height.
bool is_per_mille(const std::string& name);

/// Throws Error (invalid_scene) where a module of the scene document has both.
void refuse_both_lengths(const Json& document);

/// Takes out of `module` what the patch says in the other way.
void forget_other_lengths(Json& module, const Json& patch);

/// The module with all of its lengths in pixels of a viewport of that height: with `X` where it had
/// `X_per_mille`. Everything that draws reads these.
Module in_pixels(Module module, int viewport_height_px);

}  // namespace cutaway
