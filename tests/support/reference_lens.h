// The lens for the reference renderer, from what each shape is: slow and obvious.
#pragma once

#include "scene/scene.h"
#include "scene/view_geometry.h"

namespace cutaway::reference {

/// Distances along a ray, mm.
struct Interval {
  double begin_mm = 0.0;
  double end_mm = 0.0;
  bool is_empty() const { return end_mm <= begin_mm; }
};

/// Patient space, mm.
class ReferenceLens {
 public:
  explicit ReferenceLens(const Lens& lens);

  /// 0 in the middle, 1 on the surface, growing evenly outward.
  double gauge(glm::dvec3 position_mm) const;
  /// Empty where the ray misses.
  Interval interval(const ViewRay& ray) const;
  /// Of the surface nearest in gauge, outward, unit.
  glm::dvec3 normal(glm::dvec3 position_mm) const;
  /// The least gauge along the ray.
  double offset(const ViewRay& ray) const;
  /// How much deeper the surface may lie `reach_mm` beside a ray that crosses it in `crossed`.
  double rim_mm(const ViewRay& ray, const Interval& crossed, double reach_mm) const;

 private:
  glm::dvec3 in_body(glm::dvec3 position_mm) const;
  double least_at_mm(const ViewRay& ray) const;

  const Lens& lens_;
  glm::dvec3 half_mm_;
  glm::dmat3 axes_;
};

}  // namespace cutaway::reference
