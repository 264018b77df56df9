#include "support/reference_ray.h"

#include <algorithm>
#include <cmath>

namespace cutaway::reference {

Ray::Ray(const Scene& scene, const Volume& volume, const ViewRay& ray, double step_mm,
         int picture_height_px)
    : camera_(scene.camera),
      scene_lens_(scene.lens),
      lens_(scene.lens),
      funnel_(scene.lens, scene.camera),
      volume_(volume),
      ray_(ray),
      to_index_(patient_to_index(volume.geometry)),
      step_mm_(step_mm),
      picture_height_px_(picture_height_px),
      box_(box_interval()),
      funnel_end_mm_(clear_mm()) {}

glm::dvec3 Ray::position_mm(double distance_mm) const {
  return ray_.origin_mm + distance_mm * ray_.direction;
}

glm::dvec3 Ray::index_at(double distance_mm) const {
  return glm::dvec3(to_index_ * glm::dvec4(position_mm(distance_mm), 1.0));
}

double Ray::value(double distance_mm) const { return sample(volume_, index_at(distance_mm)); }

Interval Ray::box_interval() const {
  const glm::dvec3 origin(to_index_ * glm::dvec4(ray_.origin_mm, 1.0));
  const glm::dvec3 direction(to_index_ * glm::dvec4(ray_.direction, 0.0));
  Interval interval{0.0, 1e12};
  for (int axis = 0; axis < 3; ++axis) {
    const double last = volume_.geometry.size_voxels[axis] - 1;
    if (std::abs(direction[axis]) < 1e-12) {
      if (origin[axis] < 0.0 || origin[axis] > last) return {0.0, 0.0};
      continue;
    }
    const double a = -origin[axis] / direction[axis];
    const double b = (last - origin[axis]) / direction[axis];
    interval.begin_mm = std::max(interval.begin_mm, std::min(a, b));
    interval.end_mm = std::min(interval.end_mm, std::max(a, b));
  }
  return interval;
}

bool Ray::is_under_lens() const {
  const Interval lens = lens_.interval(ray_);
  return !lens.is_empty() && lens.end_mm > 0.0;
}

// The lens' surface two pixels away is at most so much deeper, and the focus some voxels more.
double Ray::rim_depth_mm(const RayPart& in_lens) const {
  const glm::dvec3 spacing = volume_.geometry.spacing_mm;
  const double two_voxels_mm = 2.0 * std::min({spacing.x, spacing.y, spacing.z});
  const double pixel_mm = camera_.projection == Projection::orthographic
                              ? camera_.view_height_mm / picture_height_px_
                              : in_lens.stretch.end_mm * 2.0 *
                                    std::tan(0.5 * glm::radians(camera_.vertical_fov_degrees)) /
                                    picture_height_px_;
  const double deeper_mm = lens_.rim_mm(ray_, in_lens.stretch, 2.0 * pixel_mm);
  return two_voxels_mm + 2.0 * pixel_mm + deeper_mm;
}

bool Ray::goes_on_outside(const RayPart& in_lens, const ValueBand& band) const {
  const double depth_mm = rim_depth_mm(in_lens);
  for (int i = 1; i <= 8; ++i) {
    const double behind_mm = in_lens.stretch.end_mm + depth_mm * i / 8.0;
    const double before_mm = in_lens.stretch.begin_mm - depth_mm * i / 8.0;
    if (behind_mm < box_.end_mm && band.contains(value(behind_mm))) return true;
    if (before_mm > box_.begin_mm && band.contains(value(before_mm))) return true;
  }
  return false;
}

RayPart Ray::whole(BranchName branch) const {
  return {branch, box_, box_face(), box_.begin_mm == 0.0};
}

/// Where there is a funnel no ray meets context before the lens.
double Ray::clear_mm() const {
  const Interval lens = lens_interval();
  const double before_lens_mm = lens.is_empty() ? 0.0 : lens.begin_mm;
  return scene_lens_.opening == LensOpening::funnel ? std::max(funnel_.end_mm(ray_), before_lens_mm)
                                                    : 0.0;
}

Interval Ray::lens_interval() const {
  Interval lens = lens_.interval(ray_);
  lens = {std::max(lens.begin_mm, box_.begin_mm), std::min(lens.end_mm, box_.end_mm)};
  return lens.is_empty() ? Interval{box_.end_mm, box_.end_mm} : lens;
}

std::array<RayPart, 3> Ray::cutaway_parts() const {
  const Interval lens = lens_interval();
  std::array<RayPart, 3> parts = {whole(BranchName::context), whole(BranchName::focus),
                                  whole(BranchName::context)};
  parts[0].stretch.end_mm = lens.begin_mm;
  parts[1].stretch = lens;
  parts[2].stretch.begin_mm = lens.end_mm;
  for (const int outside : {0, 2})
    parts[outside].stretch.begin_mm = std::max(parts[outside].stretch.begin_mm, funnel_end_mm_);
  for (RayPart& part : parts) {
    if (part.stretch.begin_mm <= box_.begin_mm) continue;
    part.face = lens_face(part.stretch.begin_mm);
    part.starts_open = scene_lens_.cap == LensCap::open;
  }
  return parts;
}

bool Ray::is_behind_lens(double distance_mm) const {
  const Interval lens = lens_interval();
  const bool is_funnels_cut = funnel_end_mm_ > box_.begin_mm && distance_mm <= funnel_end_mm_;
  return (!lens.is_empty() && distance_mm >= lens.end_mm) || is_funnels_cut;
}

Interval Ray::taken_from_context() const {
  const Interval lens = lens_interval();
  if (funnel_end_mm_ <= box_.begin_mm) return lens;
  return {box_.begin_mm, std::max(lens.is_empty() ? 0.0 : lens.end_mm, funnel_end_mm_)};
}

double Ray::step_end_mm(double distance_mm, const Interval& stretch) const {
  const double number = std::floor((distance_mm - box_.begin_mm) / step_mm_ + 1e-9) + 1.0;
  return std::min(box_.begin_mm + number * step_mm_, stretch.end_mm);
}

std::optional<SurfaceHit> Ray::first_surface(const RayPart& part, const ValueBand& band) const {
  double near_mm = part.stretch.begin_mm;
  int side = band.side(value(near_mm));
  if (side == 0 && !part.starts_open)
    return SurfaceHit{near_mm, part.face ? *part.face : gradient_normal(near_mm),
                      part.face.has_value()};
  while (near_mm < part.stretch.end_mm) {
    const double far_mm = step_end_mm(near_mm, part.stretch);
    const int side_there = band.side(value(far_mm));
    if (side_there != side && side != 0) {
      const double hit_mm = bisect(near_mm, far_mm, band);
      return SurfaceHit{hit_mm, gradient_normal(hit_mm)};
    }
    side = side_there;
    near_mm = far_mm;
  }
  return std::nullopt;
}

double Ray::bisect(double near_mm, double far_mm, const ValueBand& band) const {
  const int side = band.side(value(near_mm));
  for (int i = 0; i < 50; ++i) {
    const double middle_mm = 0.5 * (near_mm + far_mm);
    (band.side(value(middle_mm)) == side ? near_mm : far_mm) = middle_mm;
  }
  return 0.5 * (near_mm + far_mm);
}

glm::dvec3 Ray::facing(glm::dvec3 normal) const {
  return glm::dot(normal, ray_.direction) > 0.0 ? -normal : normal;
}

glm::dvec3 Ray::gradient_normal(double distance_mm) const {
  const glm::dvec3 index = index_at(distance_mm);
  const glm::dvec3 last(volume_.geometry.size_voxels - 1);
  glm::dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 ahead = index;
    glm::dvec3 behind = index;
    ahead[axis] = std::min(ahead[axis] + 1.0, last[axis]);
    behind[axis] = std::max(behind[axis] - 1.0, 0.0);
    const double length_mm = (ahead[axis] - behind[axis]) * volume_.geometry.spacing_mm[axis];
    gradient[axis] = (sample(volume_, ahead) - sample(volume_, behind)) / length_mm;
  }
  if (glm::length(gradient) == 0.0) return -ray_.direction;
  return facing(-glm::normalize(volume_.geometry.direction_patient * gradient));
}

std::optional<glm::dvec3> Ray::lens_face(double distance_mm) const {
  if (scene_lens_.cap != LensCap::flat && scene_lens_.cap != LensCap::section) return std::nullopt;
  const glm::dvec3 at_mm = position_mm(distance_mm);
  return facing(distance_mm == funnel_end_mm_ ? funnel_.normal(at_mm) : lens_.normal(at_mm));
}

glm::dvec3 Ray::box_face() const {
  const glm::dvec3 index = index_at(box_.begin_mm);
  const glm::dvec3 last(volume_.geometry.size_voxels - 1);
  int nearest = 0;
  double least = 1e12;
  for (int axis = 0; axis < 3; ++axis) {
    const double gap = std::min(std::abs(index[axis]), std::abs(last[axis] - index[axis]));
    if (gap < least) nearest = axis;
    least = std::min(least, gap);
  }
  return facing(volume_.geometry.direction_patient[nearest]);
}

}  // namespace cutaway::reference
