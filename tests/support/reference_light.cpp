#include "support/reference_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "support/reference_funnel.h"
#include "support/reference_lens.h"
#include "support/reference_normals.h"
#include "support/reference_pixels.h"

namespace cutaway::reference {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A pixel's number in the pattern, 0..15: of the bits of both coordinates, the coarser halves
/// last.
int number_in_pattern(glm::ivec2 pixel) {
  const bool x_odd = pixel.x % 2 != 0;
  const bool y_odd = pixel.y % 2 != 0;
  const bool x_late = pixel.x % 4 >= 2;
  const bool y_late = pixel.y % 4 >= 2;
  return (x_odd ? 8 : 0) + (x_odd != y_odd ? 4 : 0) + (x_late ? 2 : 0) + (x_late != y_late ? 1 : 0);
}

struct Place {
  glm::dvec3 position_mm;
  glm::dvec3 normal;
  double turn = 0.0;    ///< 0..1, of the directions
  double offset = 0.0;  ///< of the samples
};

class Light {
 public:
  Light(const Scene& scene, const Volume& volume, const ReferenceCopy& copy, BranchName name,
        const LightRays& rays)
      : scene_(scene),
        branch_(name == BranchName::focus ? scene.focus : scene.context),
        copy_(copy),
        size_(volume.geometry.size_voxels),
        to_index_(patient_to_index(volume.geometry)),
        lens_(scene.lens),
        funnel_(scene.lens, scene.camera),
        cuts_(scene.lens.mode == LensMode::cutaway && scene.lens.radius_mm > 0.0),
        rays_(rays),
        to_light_(light_direction_patient(scene.light, scene.camera)) {
    const glm::dvec3 spacing = volume.geometry.spacing_mm;
    start_mm_ = std::max(1.5 * std::max({spacing.x, spacing.y, spacing.z}),
                         0.5 * gaussian_mm(branch_.normals, name, volume.geometry));
    const double diagonal_mm = glm::length(spacing * glm::dvec3(size_ - 1));
    const double usual_mm = std::max(cuts_ ? 2.0 * scene.lens.radius_mm : 0.0, 0.15 * diagonal_mm);
    range_mm_ = std::max(branch_.occlusion.range_mm.value_or(usual_mm), 2.0 * start_mm_);
    shadow_range_mm_ = 0.5 * diagonal_mm;
  }

  glm::dvec2 at(Place place) const {
    place.position_mm += 0.5 * start_mm_ * place.normal;
    return {branch_.occlusion.strength > 0.0 ? ambient(place) : 1.0,
            branch_.shadow.strength > 0.0 ? direct(place) : 1.0};
  }

 private:
  double ambient(const Place& place) const {
    const auto [u, v] = across(place.normal);
    double open = 0.0;
    for (int k = 0; k < rays_.directions; ++k) {
      const double radius = std::sqrt((k + 0.5) / rays_.directions);
      const double angle = k * std::numbers::pi * (3.0 - std::sqrt(5.0)) + kTurn * place.turn;
      const glm::dvec3 direction = radius * std::cos(angle) * u + radius * std::sin(angle) * v +
                                   std::sqrt(1.0 - radius * radius) * place.normal;
      const auto blocked_mm = march(place, direction, range_mm_, rays_.samples, k);
      if (!blocked_mm)
        open += 1.0;
      else if (*blocked_mm > 0.25 * range_mm_)
        open += branch_.occlusion.near_share;
    }
    return open / rays_.directions;
  }

  double direct(const Place& place) const {
    const auto [u, v] = across(to_light_);
    const double spread = std::tan(glm::radians(branch_.shadow.softness_degrees));
    double open = 0.0;
    for (int k = 0; k < rays_.shadow_rays; ++k) {
      const double radius = spread * std::sqrt((k + 0.5) / rays_.shadow_rays);
      const double angle = kTurn * (k * 0.381966 + place.turn);
      const glm::dvec3 direction =
          glm::normalize(radius * std::cos(angle) * u + radius * std::sin(angle) * v + to_light_);
      if (!march(place, direction, shadow_range_mm_, rays_.shadow_samples, k)) open += 1.0;
    }
    const double facing = std::clamp(glm::dot(place.normal, to_light_) / 0.3, 0.0, 1.0);
    return std::lerp(1.0, open / rays_.shadow_rays, facing * facing * (3.0 - 2.0 * facing));
  }

  /// Two axes across a direction, the same that the renderer has: the pattern turns about it.
  static std::pair<glm::dvec3, glm::dvec3> across(glm::dvec3 axis) {
    const double side = axis.z >= 0.0 ? 1.0 : -1.0;
    const double a = -1.0 / (side + axis.z);
    return {{1.0 + side * axis.x * axis.x * a, side * axis.x * axis.y * a, -side * axis.x},
            {axis.x * axis.y * a, side + axis.y * axis.y * a, -axis.y}};
  }

  /// Where the ray first meets something; nothing where it does not.
  std::optional<double> march(const Place& place, glm::dvec3 direction, double length_mm, int count,
                              int number) const {
    const double whole = place.offset + number * 0.754878;
    const double offset = rays_.has_pattern ? whole - std::floor(whole) : 0.5;
    for (int i = 0; i < count; ++i) {
      const double share = (i + offset) / std::max(count - 1 + offset, 1e-3);
      const double at_mm = start_mm_ + (length_mm - start_mm_) * std::pow(share, 1.5);
      if (is_something(place.position_mm + at_mm * direction)) return at_mm;
    }
    return std::nullopt;
  }

  /// Of the branch that exists there.
  bool is_something(glm::dvec3 position_mm) const {
    const glm::dvec3 index(to_index_ * glm::dvec4(position_mm, 1.0));
    if (glm::any(glm::lessThan(index, glm::dvec3(-0.5))) ||
        glm::any(glm::greaterThan(index, glm::dvec3(size_) - 0.5)))
      return false;
    if (!cuts_) return branch_.surface.band.contains(copy_.value(index));
    if (lens_.gauge(position_mm) < 1.0)
      return scene_.focus.surface.band.contains(copy_.value(index));
    return !funnel_.holds(position_mm) && scene_.context.surface.band.contains(copy_.value(index));
  }

  const Scene& scene_;
  const Branch& branch_;
  const ReferenceCopy& copy_;
  glm::ivec3 size_;
  glm::dmat4 to_index_;
  ReferenceLens lens_;
  ReferenceFunnel funnel_;
  bool cuts_;
  LightRays rays_;
  glm::dvec3 to_light_;
  double start_mm_ = 0.0;
  double range_mm_ = 0.0;
  double shadow_range_mm_ = 0.0;
};

/// Of the pixels that lie in the same surface.
glm::dvec2 smoothed(const Image<glm::dvec2>& reach, const Image<const BranchLayers*>& met,
                    glm::ivec2 pixel, double pixel_mm) {
  const BranchLayers& centre = *met.at(pixel);
  glm::dvec2 sum(0.0);
  double weights = 0.0;
  for (int i = 0; i < 16; ++i) {
    const glm::ivec2 at =
        glm::clamp(pixel + glm::ivec2(i % 4, i / 4) - 1, glm::ivec2(0), reach.size_px - 1);
    const BranchLayers* there = met.at(at);
    if (!there || there->is_behind_lens != centre.is_behind_lens ||
        there->nearest.is_cut != centre.nearest.is_cut)
      continue;
    const double facing = std::max(glm::dot(there->nearest.normal, centre.nearest.normal), 0.0);
    const double apart =
        (there->nearest.distance_mm - centre.nearest.distance_mm) / (6.0 * pixel_mm);
    const double weight = facing * facing * std::exp(-apart * apart);
    sum += weight * reach.at(at);
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : reach.at(pixel);
}

}  // namespace

Image<glm::dvec2> light_reach(const Scene& scene, const Volume& volume, const ReferenceCopy& copy,
                              const Image<RayLayers>& rays, BranchName branch, int supersampling,
                              const LightRays& rays_of_light) {
  const Light light(scene, volume, copy, branch, rays_of_light);
  const glm::ivec2 size_px = rays.size_px / supersampling;
  Image<const BranchLayers*> met(size_px);
  Image<glm::dvec2> reach(size_px);
  for (int i = 0; i < size_px.x * size_px.y; ++i) {
    const glm::ivec2 pixel(i % size_px.x, i / size_px.x);
    for (int part = supersampling * supersampling - 1; part >= 0; --part) {
      const glm::ivec2 at =
          pixel * supersampling + glm::ivec2(part % supersampling, part / supersampling);
      const BranchLayers& layers =
          branch == BranchName::focus ? rays.at(at).focus : rays.at(at).context;
      if (layers.is_met) met.at(pixel) = &layers;
    }
    reach.at(pixel) = glm::dvec2(1.0);
    if (!met.at(pixel)) continue;
    const SurfaceHit& hit = met.at(pixel)->nearest;
    const ViewRay ray = ray_of(scene, pixel, size_px);
    const int number = number_in_pattern(pixel);
    const double turn = rays_of_light.has_pattern ? number / 16.0 : 0.0;
    reach.at(pixel) = light.at(
        {ray.origin_mm + hit.distance_mm * ray.direction, hit.normal, turn, number * 0.618034});
  }
  if (!rays_of_light.has_pattern) return reach;
  Image<glm::dvec2> smooth = reach;
  for (int i = 0; i < size_px.x * size_px.y; ++i) {
    const glm::ivec2 pixel(i % size_px.x, i / size_px.x);
    if (!met.at(pixel)) continue;
    const double pixel_mm =
        ray_spacing_mm(scene.camera, size_px.y, met.at(pixel)->nearest.distance_mm);
    smooth.at(pixel) = smoothed(reach, met, pixel, pixel_mm);
  }
  return smooth;
}

}  // namespace cutaway::reference
