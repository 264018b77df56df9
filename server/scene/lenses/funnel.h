// The way that a cutaway opens towards the eye, so that no context ever hides the focus.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "scene/scene.h"
#include "scene/view_geometry.h"

namespace cutaway {

/// What is taken from the context besides the lens: a cone's frustum from the lens' middle towards
/// the eye, as wide there as the lens and wider by `widening` per mm of height. Before any part of
/// a lens that reaches out of it there is no context either, on the rays that cross the lens.
/// Patient space, mm. Of what the idea is: M. Burns, M. Haidacher, W. Wein, I. Viola, M. E.
/// Gröller, "Feature Emphasis and Contextual Cutaways for Multimodal Medical Visualization",
/// EuroVis 2007.
struct Funnel {
  glm::dvec3 foot_mm{0.0};
  glm::dvec3 axis{0.0};  ///< unit, towards the eye
  double radius_mm = 0.0;
  double widening = 0.0;

  /// How far a ray that begins in the funnel stays there; 0 for one that does not.
  double exit_mm(const ViewRay& ray) const;
  bool operator==(const Funnel&) const = default;
};

/// Nothing where the lens takes the context away in itself alone.
std::optional<Funnel> funnel_of(const Lens& lens, const Camera& camera);

}  // namespace cutaway
