// What a scene shows under a point, found on the CPU by the same rule that the renderer follows.
#pragma once

#include <optional>

#include "scene/server_message.h"
#include "scene/view_geometry.h"
#include "session/volume_library.h"

namespace cutaway {

struct PickHit {
  glm::dvec3 position_mm;
  double limit_value;  ///< of the surface that was hit
  PictureBranch branch;
};

/// The visible surface under a point of the viewport: the context's outside of the lens, the focus'
/// inside of it, whichever comes first along the ray (techniques: the cutaway lens' four cases);
/// nothing where there is neither.
std::optional<PickHit> pick(const Scene& scene, const OpenVolume& volume, glm::dvec2 position_px);

/// The point of a slice's plane that its viewport shows there, and its value; nothing beside the
/// volume.
struct SlicePoint {
  glm::dvec3 position_mm;
  double value;
};
std::optional<SlicePoint> pick_on_slice(const Scene& scene, const OpenVolume& volume,
                                        glm::dvec2 position_px);

/// Where drag_lens puts the lens: on the context's surface under the point as if there were no
/// lens; beside the volume on the plane through the present centre that faces the viewer, or the
/// present centre where that plane is not ahead.
glm::dvec3 dragged_lens_centre(const Scene& scene, const OpenVolume& volume,
                               glm::dvec2 position_px);

}  // namespace cutaway
