// The cavity's wall and the colours of cut tissue, for the reference renderer.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "scene/view_geometry.h"
#include "support/reference_layers.h"
#include "volume/volume.h"

namespace cutaway::reference {

/// Colours over a range of physical values, evenly.
struct Tissues {
  ValueRange range;
  std::vector<glm::dvec3> colours;
};

/// Whether the context's wall or its cuts are drawn in another way than the rest of it.
bool has_wall(const Scene& scene);

/// What that makes of a context's point that is `shaded` like the rest.
glm::dvec3 wall(const Scene& scene, const Volume& volume, const Tissues& tissues,
                const BranchLayers& layers, const ViewRay& ray, glm::dvec3 shaded);

}  // namespace cutaway::reference
