#include "session/pick.h"

#include <algorithm>
#include <array>
#include <limits>

#include "scene/lenses/funnel.h"
#include "scene/lenses/lens_body.h"
#include "scene/slice_geometry.h"

namespace cutaway {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

// Distances along a ray, mm.
struct Stretch {
  double begin = 0.0;
  double end = kEndless;
  PictureBranch branch = PictureBranch::context;
  bool begins_at_lens = false;
};

// The part of the ray inside the lens.
std::optional<Stretch> inside_lens(const Lens& lens, const ViewRay& ray) {
  if (lens.mode == LensMode::none || lens.radius_mm <= 0.0) return std::nullopt;
  const auto lens_mm = LensBody(lens).interval_mm(ray);
  if (!lens_mm || lens_mm->y <= 0.0) return std::nullopt;
  const double begin = std::max(0.0, lens_mm->x);
  return Stretch{begin, lens_mm->y, PictureBranch::focus, begin > 0.0};
}

// Material that a stretch starts in does not count where a cap is left open, nor around an eye that
// stands in it: the surface counts only where the value enters the band again.
std::optional<double> past_open_cap(const OpenVolume& volume, const ViewRay& ray,
                                    const ValueBand& band, const Stretch& stretch) {
  const double step_mm = volume.facts().diagonal_mm / 1000.0;
  const double end = std::min(stretch.end, stretch.begin + (2.0 * volume.facts().diagonal_mm));
  for (double distance = stretch.begin; distance <= end; distance += step_mm) {
    const auto value = volume.value_at(ray.origin_mm + (distance * ray.direction));
    if (!value || !band.contains(*value)) return distance;
  }
  return std::nullopt;
}

const ValueBand& band_of(const Scene& scene, PictureBranch branch) {
  return (branch == PictureBranch::focus ? scene.focus : scene.context).surface.band;
}

std::optional<PickHit> first_hit(const Scene& scene, const OpenVolume& volume, const ViewRay& ray,
                                 const Stretch& stretch) {
  const ValueBand& band = band_of(scene, stretch.branch);
  std::optional<double> begin = stretch.begin;
  const bool at_eye = stretch.begin == 0.0;
  if (at_eye || (stretch.begins_at_lens && scene.lens.cap == LensCap::open)) {
    begin = past_open_cap(volume, ray, band, stretch);
  }
  if (!begin) return std::nullopt;
  const auto position =
      volume.probe(scene)(ray.origin_mm + (*begin * ray.direction), ray.direction, band);
  if (!position) return std::nullopt;
  const double distance = glm::dot(*position - ray.origin_mm, ray.direction);
  if (distance > stretch.end) return std::nullopt;
  return PickHit{*position, band.lower, stretch.branch};
}

// The Magic Lens shows the whole ray's focus, and the context where there is none.
std::optional<PickHit> pick_under_magic_lens(const Scene& scene, const OpenVolume& volume,
                                             const ViewRay& ray) {
  const auto focus = first_hit(scene, volume, ray, {.begin = 0.0, .branch = PictureBranch::focus});
  return focus ? focus : first_hit(scene, volume, ray, Stretch{});
}

}  // namespace

std::optional<PickHit> pick(const Scene& scene, const OpenVolume& volume, glm::dvec2 position_px) {
  const ViewRay ray = ray_through(scene.camera, scene.viewport, position_px);
  const std::optional<Stretch> lens = inside_lens(scene.lens, ray);
  const auto funnel = funnel_of(scene.lens, scene.camera);
  double opened = funnel ? funnel->exit_mm(ray) : 0.0;
  if (lens && funnel) opened = std::max(opened, lens->begin);
  if (!lens)
    return first_hit(scene, volume, ray, {.begin = opened, .begins_at_lens = opened > 0.0});
  if (scene.lens.mode == LensMode::magic) return pick_under_magic_lens(scene, volume, ray);
  const std::array stretches = {
      Stretch{opened, lens->begin, PictureBranch::context, opened > 0.0}, *lens,
      Stretch{std::max(lens->end, opened), kEndless, PictureBranch::context, true}};
  for (const Stretch& stretch : stretches) {
    if (stretch.begin >= stretch.end) continue;
    if (const auto hit = first_hit(scene, volume, ray, stretch)) return hit;
  }
  return std::nullopt;
}

std::optional<SlicePoint> pick_on_slice(const Scene& scene, const OpenVolume& volume,
                                        glm::dvec2 position_px) {
  const Camera camera = slice_camera(scene, volume.facts().grid_half_axes_mm);
  const glm::dvec3 position_mm = ray_through(camera, scene.viewport, position_px).origin_mm;
  const auto value = volume.value_to_the_faces(position_mm);
  if (!value) return std::nullopt;
  return SlicePoint{position_mm, *value};
}

glm::dvec3 dragged_lens_centre(const Scene& scene, const OpenVolume& volume,
                               glm::dvec2 position_px) {
  const ViewRay ray = ray_through(scene.camera, scene.viewport, position_px);
  if (const auto hit = first_hit(scene, volume, ray, Stretch{})) return hit->position_mm;
  const glm::dvec3 forward = -camera_axes(scene.camera).backward;
  const double depth = glm::dot(scene.lens.centre_mm - ray.origin_mm, forward);
  const double slant = glm::dot(ray.direction, forward);
  if (depth <= 0.0 || slant <= 0.0) return scene.lens.centre_mm;
  return ray.origin_mm + (ray.direction * (depth / slant));
}

}  // namespace cutaway
