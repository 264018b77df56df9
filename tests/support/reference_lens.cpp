#include "support/reference_lens.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace cutaway::reference {

namespace {

glm::dvec3 half_mm(const Lens& lens) {
  const Json& said = lens.shape.parameters;
  const std::string& shape = lens.shape.name;
  glm::dvec3 radii(1.0);
  if (shape == "ellipsoid" || shape == "box")
    radii = {said.at("width"), said.at("height"), said.at("depth")};
  if (shape == "cylinder" || shape == "cone") radii.z = said.at("length");
  return lens.radius_mm * radii;
}

// First the roll about the direction it points in, then tilted up, then turned to the left; at rest
// x is left, y the head, z the front.
glm::dmat3 axes(const Json& said) {
  const auto turn = [&](const char* name, glm::dvec3 about) {
    const double angle = glm::radians(said.value(name, 0.0));
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), angle, about));
  };
  const glm::dmat3 rest{{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}};
  return turn("azimuth_degrees", {0.0, 0.0, 1.0}) * turn("elevation_degrees", {-1.0, 0.0, 0.0}) *
         rest * turn("roll_degrees", {0.0, 0.0, 1.0});
}

}  // namespace

ReferenceLens::ReferenceLens(const Lens& lens)
    : lens_(lens), half_mm_(half_mm(lens)), axes_(axes(lens.shape.parameters)) {}

glm::dvec3 ReferenceLens::in_body(glm::dvec3 position_mm) const {
  return glm::inverse(axes_) * (position_mm - lens_.centre_mm) / half_mm_;
}

double ReferenceLens::gauge(glm::dvec3 position_mm) const {
  const glm::dvec3 p = in_body(position_mm);
  const double from_axis = std::hypot(p.x, p.y);
  if (lens_.shape.name == "box") return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (lens_.shape.name == "cylinder") return std::max(from_axis, std::abs(p.z));
  if (lens_.shape.name == "cone") return std::max(p.z, 2.0 * from_axis - p.z);
  return glm::length(p);
}

double ReferenceLens::least_at_mm(const ViewRay& ray) const {
  const double middle_mm = glm::dot(lens_.centre_mm - ray.origin_mm, ray.direction);
  const double reach_mm = 4.0 * glm::length(half_mm_);
  double low_mm = middle_mm - reach_mm;
  double high_mm = middle_mm + reach_mm;
  for (int i = 0; i < 120; ++i) {
    const double third_mm = (high_mm - low_mm) / 3.0;
    const double before = gauge(ray.origin_mm + (low_mm + third_mm) * ray.direction);
    const double behind = gauge(ray.origin_mm + (high_mm - third_mm) * ray.direction);
    (before < behind ? high_mm : low_mm) += before < behind ? -third_mm : third_mm;
  }
  return 0.5 * (low_mm + high_mm);
}

double ReferenceLens::offset(const ViewRay& ray) const {
  return gauge(ray.origin_mm + least_at_mm(ray) * ray.direction);
}

Interval ReferenceLens::interval(const ViewRay& ray) const {
  if (lens_.mode == LensMode::none || lens_.radius_mm <= 0.0 || offset(ray) >= 1.0) return {};
  const double least_mm = least_at_mm(ray);
  const auto surface_mm = [&](double towards) {
    double inside_mm = least_mm;
    double outside_mm = least_mm + towards * 4.0 * glm::length(half_mm_);
    for (int i = 0; i < 60; ++i) {
      const double half_way_mm = 0.5 * (inside_mm + outside_mm);
      const bool is_inside = gauge(ray.origin_mm + half_way_mm * ray.direction) < 1.0;
      (is_inside ? inside_mm : outside_mm) = half_way_mm;
    }
    return 0.5 * (inside_mm + outside_mm);
  };
  return {surface_mm(-1.0), surface_mm(1.0)};
}

glm::dvec3 ReferenceLens::normal(glm::dvec3 position_mm) const {
  const double step_mm = 1e-6 * lens_.radius_mm;
  glm::dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = step_mm;
    gradient[axis] = gauge(position_mm + step) - gauge(position_mm - step);
  }
  return glm::normalize(gradient);
}

// Half a ball's chord grows by at most sqrt(half^2 + 2 reach) - half; of the others the ray that
// passes so much nearer to the middle is looked at.
double ReferenceLens::rim_mm(const ViewRay& ray, const Interval& crossed, double reach_mm) const {
  const double reach = reach_mm / std::min({half_mm_.x, half_mm_.y, half_mm_.z});
  const glm::dvec3 along = glm::inverse(axes_) * ray.direction / half_mm_;
  if (lens_.shape.name == "sphere" || lens_.shape.name == "ellipsoid") {
    const double half = 0.5 * (crossed.end_mm - crossed.begin_mm) * glm::length(along);
    return (std::sqrt(half * half + 2.0 * reach) - half) / glm::length(along);
  }
  const glm::dvec3 origin = in_body(ray.origin_mm);
  const double foot_mm = -glm::dot(origin, along) / glm::dot(along, along);
  const glm::dvec3 foot = origin + foot_mm * along;
  const glm::dvec3 nearer = std::max(0.0, 1.0 - reach / glm::length(foot)) * foot;
  const glm::dvec3 begin_mm = axes_ * ((nearer - foot_mm * along) * half_mm_) + lens_.centre_mm;
  const Interval there = interval({begin_mm, ray.direction});
  return std::max({there.end_mm - crossed.end_mm, crossed.begin_mm - there.begin_mm, 0.0});
}

}  // namespace cutaway::reference
