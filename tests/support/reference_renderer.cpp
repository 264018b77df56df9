#include "support/reference_renderer.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/view_geometry.h"
#include "support/reference_filters.h"
#include "support/reference_shading.h"

namespace cutaway::reference {

namespace {

struct Interval {
  double begin_mm = 0.0;
  double end_mm = 0.0;
  bool is_empty() const { return end_mm <= begin_mm; }
};

/// One ray through one scene.
class Tracer {
 public:
  Tracer(const Scene& scene, const Volume& volume, const ViewRay& ray, double step_mm)
      : scene_(scene),
        volume_(volume),
        ray_(ray),
        to_index_(patient_to_index(volume.geometry)),
        step_mm_(step_mm),
        box_(box_interval()),
        lens_(lens_interval()) {}

  SurfaceSample trace() const {
    SurfaceSample none;
    if (box_.is_empty()) return none;
    if (lens_.is_empty())
      return search(Label::context, box_, box_face(), eye_in_volume()).value_or(none);
    const bool begins_in_lens = lens_.begin_mm <= box_.begin_mm;
    if (!begins_in_lens) {
      const auto front =
          search(Label::context, {box_.begin_mm, lens_.begin_mm}, box_face(), eye_in_volume());
      if (front) return *front;
    }
    const auto inside = begins_in_lens
                            ? search(Label::focus, lens_, box_face(), eye_in_volume())
                            : search(Label::focus, lens_, lens_face(lens_.begin_mm), opens());
    if (inside) return *inside;
    none.lens_was_crossed = true;
    if (lens_.end_mm >= box_.end_mm) return none;
    auto behind =
        search(Label::context, {lens_.end_mm, box_.end_mm}, lens_face(lens_.end_mm), opens());
    if (behind) behind->lens_was_crossed = true;
    return behind.value_or(none);
  }

 private:
  glm::dvec3 position_mm(double distance_mm) const {
    return ray_.origin_mm + distance_mm * ray_.direction;
  }
  glm::dvec3 index_at(double distance_mm) const {
    return glm::dvec3(to_index_ * glm::dvec4(position_mm(distance_mm), 1.0));
  }
  double value(double distance_mm) const { return sample(volume_, index_at(distance_mm)); }
  bool eye_in_volume() const { return box_.begin_mm == 0.0; }
  bool opens() const { return scene_.lens.cap == LensCap::open; }

  Interval box_interval() const {
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

  Interval lens_interval() const {
    const Lens& lens = scene_.lens;
    if (lens.mode == LensMode::none || lens.radius_mm <= 0.0) return {};
    const glm::dvec3 from_centre = ray_.origin_mm - lens.centre_mm;
    const double half_b = glm::dot(from_centre, ray_.direction);
    const double discriminant =
        half_b * half_b - glm::dot(from_centre, from_centre) + lens.radius_mm * lens.radius_mm;
    if (discriminant <= 0.0) return {};
    const double root = std::sqrt(discriminant);
    return {std::max(-half_b - root, box_.begin_mm), std::min(-half_b + root, box_.end_mm)};
  }

  /// The first point of the stretch in the branch's material, or its surface where it
  /// `starts_open`.
  std::optional<SurfaceSample> search(Label branch, Interval stretch,
                                      std::optional<glm::dvec3> face, bool starts_open) const {
    const double iso = branch == Label::focus ? scene_.focus.iso_value : scene_.context.iso_value;
    bool inside = value(stretch.begin_mm) >= iso;
    if (inside && !starts_open) {
      return SurfaceSample{branch, stretch.begin_mm,
                           face.value_or(gradient_normal(stretch.begin_mm))};
    }
    double before = stretch.begin_mm;
    for (auto n = std::floor((stretch.begin_mm - box_.begin_mm) / step_mm_) + 1.0;
         before < stretch.end_mm; ++n) {
      const double at = std::min(box_.begin_mm + n * step_mm_, stretch.end_mm);
      const bool reached = value(at) >= iso;
      if (reached && !inside) {
        const double hit = bisect(before, at, iso);
        return SurfaceSample{branch, hit, gradient_normal(hit)};
      }
      inside = reached;
      before = at;
    }
    return std::nullopt;
  }

  double bisect(double low, double high, double iso) const {
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (value(middle) >= iso ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }

  glm::dvec3 facing(glm::dvec3 normal) const {
    return glm::dot(normal, ray_.direction) > 0.0 ? -normal : normal;
  }

  glm::dvec3 gradient_normal(double distance_mm) const {
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

  std::optional<glm::dvec3> lens_face(double distance_mm) const {
    if (scene_.lens.cap != LensCap::flat) return std::nullopt;
    return facing(glm::normalize(position_mm(distance_mm) - scene_.lens.centre_mm));
  }

  glm::dvec3 box_face() const {
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

  const Scene& scene_;
  const Volume& volume_;
  ViewRay ray_;
  glm::dmat4 to_index_;
  double step_mm_;
  Interval box_;
  Interval lens_;
};

Image<SurfaceSample> cast_rays(const Scene& scene, const Volume& volume, const Settings& settings) {
  Image<SurfaceSample> surface(settings.picture_size_px * settings.supersampling);
  const glm::dvec3 spacing = volume.geometry.spacing_mm;
  const double step_mm = settings.step_voxels * std::min({spacing.x, spacing.y, spacing.z});
  const glm::dvec2 per_ray =
      glm::dvec2(scene.viewport.width_px, scene.viewport.height_px) / glm::dvec2(surface.size_px);
  for (int y = 0; y < surface.size_px.y; ++y) {
    for (int x = 0; x < surface.size_px.x; ++x) {
      const ViewRay ray =
          ray_through(scene.camera, scene.viewport, (glm::dvec2(x, y) + 0.5) * per_ray);
      surface.at({x, y}) = Tracer(scene, volume, ray, step_mm).trace();
    }
  }
  return surface;
}

BranchPixel shade_pixel(const Scene& scene, const Image<SurfaceSample>& surface, glm::ivec2 pixel,
                        Label branch, int supersampling) {
  const Module& shading = branch == Label::focus ? scene.focus.shading : scene.context.shading;
  const glm::dvec3 to_light = light_direction_patient(scene.light, scene.camera);
  const glm::dvec2 per_ray =
      glm::dvec2(scene.viewport.width_px, scene.viewport.height_px) / glm::dvec2(surface.size_px);
  BranchPixel result;
  const double share = 1.0 / (supersampling * supersampling);
  for (int i = 0; i < supersampling * supersampling; ++i) {
    const glm::ivec2 at = pixel * supersampling + glm::ivec2(i % supersampling, i / supersampling);
    const SurfaceSample& hit = surface.at(at);
    if (hit.label == branch) {
      const ViewRay ray =
          ray_through(scene.camera, scene.viewport, (glm::dvec2(at) + 0.5) * per_ray);
      result.colour += shade(shading, hit.normal, to_light, -ray.direction);
      result.coverage += share;
    }
    const bool taken_by_lens = branch == Label::focus
                                   ? hit.label == Label::context && !hit.lens_was_crossed
                                   : hit.label == Label::focus;
    if (hit.label == branch || taken_by_lens) result.silhouette_coverage += share;
  }
  if (result.coverage > 0.0) result.colour *= share / result.coverage;
  return result;
}

BranchImage draw_branch(const Scene& scene, const Image<SurfaceSample>& surface, Label label,
                        const Settings& settings) {
  BranchImage image(settings.picture_size_px);
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x) {
      image.at({x, y}) = shade_pixel(scene, surface, {x, y}, label, settings.supersampling);
    }
  }
  const Branch& branch = label == Label::focus ? scene.focus : scene.context;
  for (const Module& filter : branch.filters)
    image = apply_filter(image, filter, settings.resolution_scale);
  return image;
}

}  // namespace

Result render(const Scene& scene, const Volume& volume, const Settings& settings) {
  Result result{cast_rays(scene, volume, settings), ColourImage(settings.picture_size_px)};
  const BranchImage context = draw_branch(scene, result.surface, Label::context, settings);
  const BranchImage focus = draw_branch(scene, result.surface, Label::focus, settings);
  for (std::size_t i = 0; i < result.picture.pixels.size(); ++i) {
    const BranchPixel& c = context.pixels[i];
    const BranchPixel& f = focus.pixels[i];
    result.picture.pixels[i] = c.coverage * c.colour + f.coverage * f.colour +
                               (1.0 - c.coverage - f.coverage) * scene.background.colour;
  }
  return result;
}

}  // namespace cutaway::reference
