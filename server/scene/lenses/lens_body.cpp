#include "scene/lenses/lens_body.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/check.h"
#include "scene/modules.h"

namespace cutaway {

namespace {

/// A lens of no size is small instead: its maps stay finite.
constexpr double kSmallest_mm = 1e-6;

double degrees_or_0(const Json& parameters, const char* name) {
  return glm::radians(parameters.value(name, 0.0));
}

/// The body's z towards the patient's front and its y upwards, then turned: azimuth to the
/// patient's left, elevation upwards, roll about z.
glm::dmat3 body_axes(const Json& parameters) {
  const double azimuth = degrees_or_0(parameters, "azimuth_degrees");
  const double elevation = degrees_or_0(parameters, "elevation_degrees");
  const double roll = degrees_or_0(parameters, "roll_degrees");
  const glm::dvec3 level(std::sin(azimuth), -std::cos(azimuth), 0.0);
  const glm::dvec3 superior(0.0, 0.0, 1.0);
  const glm::dvec3 z = std::cos(elevation) * level + std::sin(elevation) * superior;
  const glm::dvec3 upright = std::cos(elevation) * superior - std::sin(elevation) * level;
  const glm::dvec3 aside = glm::cross(upright, z);
  return {std::cos(roll) * aside + std::sin(roll) * upright,
          std::cos(roll) * upright - std::sin(roll) * aside, z};
}

glm::dvec3 half_size_mm(const Module& shape, double radius_mm) {
  glm::dvec3 size(1.0);
  for (const auto& [axis, parameter] : lens_axes(shape.name))
    size[axis] = shape.parameters.at(parameter).get<double>();
  return glm::max(radius_mm * size, kSmallest_mm);
}

glm::dmat3 stretched(const glm::dmat3& axes, glm::dvec3 half_size_mm) {
  return {axes[0] * half_size_mm.x, axes[1] * half_size_mm.y, axes[2] * half_size_mm.z};
}

}  // namespace

LensBody::LensBody(const Lens& lens)
    : body_(find_lens_shape(lens.shape.name).body),
      centre_mm_(lens.centre_mm),
      half_edges_mm_(
          stretched(body_axes(lens.shape.parameters), half_size_mm(lens.shape, lens.radius_mm))),
      body_from_patient_(glm::inverse(half_edges_mm_)) {}

LensBody LensBody::at(glm::dvec3 centre_mm, double size) const {
  LensBody moved = *this;
  moved.centre_mm_ = centre_mm;
  moved.half_edges_mm_ *= size;
  moved.body_from_patient_ /= size;
  return moved;
}

std::optional<glm::dvec2> LensBody::interval_mm(const ViewRay& ray) const {
  const glm::dvec3 origin = body_from_patient_ * (ray.origin_mm - centre_mm_);
  const glm::dvec3 direction = body_from_patient_ * ray.direction;
  const double foot_mm = -glm::dot(origin, direction) / glm::dot(direction, direction);
  const glm::dvec2 interval = body_->interval(origin + foot_mm * direction, direction);
  if (interval.y <= interval.x) return std::nullopt;
  return foot_mm + interval;
}

// Of its section's corners; between two of them a curve bulges by a little.
double LensBody::reach_mm(glm::dvec3 direction) const {
  constexpr double kBulge = 1.002;
  const glm::dvec3 along = glm::transpose(half_edges_mm_) * direction;
  const double aside =
      body_->is_round ? std::hypot(along.x, along.y) : std::abs(along.x) + std::abs(along.y);
  double farthest_mm = 0.0;
  for (const glm::dvec2& corner : body_->profile)
    farthest_mm = std::max(farthest_mm, corner.x * aside + std::abs(corner.y * along.z));
  return kBulge * farthest_mm;
}

double LensBody::body_per_mm() const {
  return 1.0 / std::min({glm::length(half_edges_mm_[0]), glm::length(half_edges_mm_[1]),
                         glm::length(half_edges_mm_[2])});
}

}  // namespace cutaway
