#include "scene/lenses/funnel.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>

#include "scene/lenses/lens_body.h"

namespace cutaway {

namespace {

constexpr double kNearlyNone = 1e-9;

/// The smallest root above 0 of a t^2 + 2 b t + c, which is below 0 at t = 0; infinite: none.
double first_root(double a, double b, double c) {
  const double none = std::numeric_limits<double>::infinity();
  if (std::abs(a) < kNearlyNone) return b > 0.0 ? -c / (2.0 * b) : none;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return none;
  const double half = -(b + std::copysign(std::sqrt(discriminant), b));
  const double one = half / a;
  const double other = half != 0.0 ? c / half : none;
  const double smaller = std::min(one, other);
  const double larger = std::max(one, other);
  return smaller > 0.0 ? smaller : larger > 0.0 ? larger : none;
}

}  // namespace

double Funnel::exit_mm(const ViewRay& ray) const {
  const glm::dvec3 from_foot = ray.origin_mm - foot_mm;
  const double height = glm::dot(from_foot, axis);
  const double climb = glm::dot(ray.direction, axis);
  const double reach = radius_mm + height * widening;
  const double c = glm::dot(from_foot, from_foot) - height * height - reach * reach;
  if (height <= 0.0 || reach <= 0.0 || c >= 0.0) return 0.0;
  const double a = 1.0 - climb * climb * (1.0 + widening * widening);
  const double b = glm::dot(from_foot, ray.direction) - height * climb - reach * climb * widening;
  const double to_foot = climb < 0.0 ? -height / climb : std::numeric_limits<double>::infinity();
  return std::min(first_root(a, b, c), to_foot);
}

// As wide as the lens is across the axis, whatever its shape.
std::optional<Funnel> funnel_of(const Lens& lens, const Camera& camera) {
  if (lens.mode != LensMode::cutaway || lens.opening != LensOpening::funnel ||
      lens.radius_mm <= 0.0)
    return std::nullopt;
  const CameraAxes axes = camera_axes(camera);
  const glm::dvec3 to_eye = camera.eye_mm - lens.centre_mm;
  const bool has_eye =
      camera.projection == Projection::perspective && glm::length(to_eye) > kNearlyNone;
  const glm::dvec3 axis = has_eye ? glm::normalize(to_eye) : axes.backward;
  const glm::dvec3 aside = glm::normalize(glm::cross(axis, axes.up));
  const LensBody body(lens);
  return Funnel{lens.centre_mm, axis,
                std::max(body.reach_mm(aside), body.reach_mm(glm::cross(aside, axis))),
                std::tan(glm::radians(lens.funnel_degrees))};
}

}  // namespace cutaway
