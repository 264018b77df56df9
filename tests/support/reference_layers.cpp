#include "support/reference_layers.h"

#include <algorithm>
#include <cmath>

#include "support/reference_shading.h"

namespace cutaway::reference {

namespace {

/// As the renderer has it: what is behind so little is not looked at.
constexpr double kLeastTransmittance = 0.002;

class Accumulation {
 public:
  Accumulation(const Scene& scene, const Ray& ray)
      : scene_(scene), ray_(ray), to_light_(light_direction_patient(scene.light, scene.camera)) {}

  void add(const RayPart& part, double& transmittance, RayLayers& layers) const {
    if (part.stretch.is_empty() || transmittance <= kLeastTransmittance) return;
    const bool is_focus = part.branch == BranchName::focus;
    const Branch& branch = is_focus ? scene_.focus : scene_.context;
    BranchLayers& target = is_focus ? layers.focus : layers.context;
    if (branch.surface.opacity >= 1.0) {
      const auto hit = ray_.first_surface(part, branch.surface.band);
      if (hit) add_layer(branch, *hit, 1.0, transmittance, target);
    } else {
      add_material(branch, part, transmittance, target);
    }
  }

 private:
  void add_layer(const Branch& branch, const SurfaceHit& hit, double opacity, double& transmittance,
                 BranchLayers& target) const {
    const double weight = transmittance * opacity;
    target.colour += weight * shade(branch.shading, hit.normal, to_light_, -ray_.direction());
    target.opacity += weight;
    transmittance -= weight;
    if (!target.is_met) target.nearest = hit;
    target.is_met = true;
  }

  void add_material(const Branch& branch, const RayPart& part, double& transmittance,
                    BranchLayers& target) const {
    double near_mm = part.stretch.begin_mm;
    while (near_mm < part.stretch.end_mm && transmittance > kLeastTransmittance) {
      const double far_mm = ray_.step_end_mm(near_mm, part.stretch);
      const Interval inside = in_band(branch.surface.band, near_mm, far_mm);
      if (!inside.is_empty()) {
        const double middle_mm = 0.5 * (inside.begin_mm + inside.end_mm);
        const double length_mm = inside.end_mm - inside.begin_mm;
        const double opacity = 1.0 - std::pow(1.0 - branch.surface.opacity, length_mm);
        add_layer(branch, {middle_mm, ray_.gradient_normal(middle_mm)}, opacity, transmittance,
                  target);
      }
      near_mm = far_mm;
    }
  }

  /// The part of a step along which a value that changes linearly lies in the band.
  Interval in_band(const ValueBand& band, double near_mm, double far_mm) const {
    const double from = ray_.value(near_mm);
    const double to = ray_.value(far_mm);
    if (from == to) return band.contains(from) ? Interval{near_mm, far_mm} : Interval{};
    const double at_lower = (band.lower - from) / (to - from);
    const double at_upper = (band.upper - from) / (to - from);
    const double begin = std::clamp(std::min(at_lower, at_upper), 0.0, 1.0);
    const double end = std::clamp(std::max(at_lower, at_upper), 0.0, 1.0);
    return {std::lerp(near_mm, far_mm, begin), std::lerp(near_mm, far_mm, end)};
  }

  const Scene& scene_;
  const Ray& ray_;
  glm::dvec3 to_light_;
};

RayLayers cutaway_layers(const Ray& ray, const Accumulation& accumulation, const Scene& scene) {
  RayLayers layers;
  double transmittance = 1.0;
  const auto parts = ray.cutaway_parts();
  accumulation.add(parts[0], transmittance, layers);
  const bool reaches_lens = !parts[1].stretch.is_empty() && transmittance > kLeastTransmittance;
  accumulation.add(parts[1], transmittance, layers);
  accumulation.add(parts[2], transmittance, layers);
  layers.context.is_behind_lens =
      layers.context.is_met && ray.is_behind_lens(layers.context.nearest.distance_mm);
  const bool taken = reaches_lens ? ray.goes_on_outside(parts[1], scene.focus.surface.band)
                                  : layers.context.is_met;
  layers.focus.within_outline = layers.focus.is_met || taken;
  RayPart context_in_lens = ray.whole(BranchName::context);
  context_in_lens.stretch = ray.taken_from_context();
  context_in_lens.starts_open = context_in_lens.stretch.begin_mm == 0.0;
  layers.context.within_outline =
      layers.context.is_met || layers.focus.is_met ||
      (!context_in_lens.stretch.is_empty() &&
       ray.first_surface(context_in_lens, scene.context.surface.band).has_value());
  return layers;
}

RayLayers magic_layers(const Ray& ray, const Accumulation& accumulation) {
  RayLayers layers;
  double transmittance = 1.0;
  accumulation.add(ray.whole(BranchName::context), transmittance, layers);
  layers.context.within_outline = layers.context.is_met;
  layers.focus.within_outline = true;
  if (!ray.is_under_lens()) return layers;
  transmittance = 1.0;
  accumulation.add(ray.whole(BranchName::focus), transmittance, layers);
  layers.focus.within_outline = layers.focus.is_met;
  return layers;
}

}  // namespace

RayLayers trace(const Scene& scene, const Volume& volume, const ViewRay& view_ray, double step_mm,
                int picture_height_px) {
  const Ray ray(scene, volume, view_ray, step_mm, picture_height_px);
  if (ray.in_volume().is_empty()) return {};
  const Accumulation accumulation(scene, ray);
  const bool is_magic = scene.lens.mode == LensMode::magic && scene.lens.radius_mm > 0.0;
  return is_magic ? magic_layers(ray, accumulation) : cutaway_layers(ray, accumulation, scene);
}

}  // namespace cutaway::reference
