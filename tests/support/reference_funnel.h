// The cutaway's funnel for the reference renderer, from what it is: slow and obvious.
#pragma once

#include "scene/scene.h"
#include "scene/view_geometry.h"

namespace cutaway::reference {

/// Patient space, mm.
class ReferenceFunnel {
 public:
  /// Of no extent where the lens has none.
  ReferenceFunnel(const Lens& lens, const Camera& camera);

  /// Whether the context is taken away there; the lens apart.
  bool holds(glm::dvec3 position_mm) const;
  /// Up to where a ray that begins in it stays; 0 for one that does not.
  double end_mm(const ViewRay& ray) const;
  /// Outward, unit, of its side, or of its foot.
  glm::dvec3 normal(glm::dvec3 position_mm) const;

 private:
  bool is_open_ = false;
  glm::dvec3 foot_mm_{0.0};
  glm::dvec3 axis_{0.0};
  double radius_mm_ = 0.0;
  double widening_ = 0.0;
};

}  // namespace cutaway::reference
