#include "support/reference_funnel.h"

#include <algorithm>
#include <cmath>

#include "scene/lenses/lens_body.h"

namespace cutaway::reference {

ReferenceFunnel::ReferenceFunnel(const Lens& lens, const Camera& camera)
    : is_open_(lens.mode == LensMode::cutaway && lens.opening == LensOpening::funnel &&
               lens.radius_mm > 0.0),
      foot_mm_(lens.centre_mm),
      widening_(std::tan(glm::radians(lens.funnel_degrees))) {
  if (!is_open_) return;
  const CameraAxes view = camera_axes(camera);
  const bool has_eye =
      camera.projection == Projection::perspective && glm::distance(camera.eye_mm, foot_mm_) > 1e-9;
  axis_ = has_eye ? glm::normalize(camera.eye_mm - foot_mm_) : view.backward;
  const glm::dvec3 aside = glm::normalize(glm::cross(axis_, view.up));
  const LensBody body(lens);
  radius_mm_ = std::max(body.reach_mm(aside), body.reach_mm(glm::cross(aside, axis_)));
}

bool ReferenceFunnel::holds(glm::dvec3 position_mm) const {
  const double height = glm::dot(position_mm - foot_mm_, axis_);
  const double from_axis = glm::length(position_mm - foot_mm_ - height * axis_);
  return is_open_ && height >= 0.0 && from_axis <= radius_mm_ + height * widening_;
}

// It is convex: a ray that has left it does not come back.
double ReferenceFunnel::end_mm(const ViewRay& ray) const {
  if (!holds(ray.origin_mm)) return 0.0;
  double inside_mm = 0.0;
  double outside_mm = 1e6;
  if (holds(ray.origin_mm + outside_mm * ray.direction)) return outside_mm;
  for (int i = 0; i < 80; ++i) {
    const double half_way_mm = 0.5 * (inside_mm + outside_mm);
    (holds(ray.origin_mm + half_way_mm * ray.direction) ? inside_mm : outside_mm) = half_way_mm;
  }
  return 0.5 * (inside_mm + outside_mm);
}

glm::dvec3 ReferenceFunnel::normal(glm::dvec3 position_mm) const {
  const double height = glm::dot(position_mm - foot_mm_, axis_);
  const glm::dvec3 across = position_mm - foot_mm_ - height * axis_;
  const bool is_foot = height < 1e-3 * radius_mm_ && glm::length(across) < 0.999 * radius_mm_;
  return is_foot ? -axis_ : glm::normalize(glm::normalize(across) - widening_ * axis_);
}

}  // namespace cutaway::reference
