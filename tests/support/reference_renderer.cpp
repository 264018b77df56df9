#include "support/reference_renderer.h"

#include <algorithm>
#include <cmath>

#include "scene/relative_lengths.h"
#include "scene/view_geometry.h"
#include "support/reference_filters.h"
#include "support/reference_looks.h"
#include "support/reference_pixels.h"

namespace cutaway::reference {

namespace {

Image<RayLayers> cast_rays(const Scene& scene, const Volume& volume, const Settings& settings) {
  Image<RayLayers> rays(settings.picture_size_px * settings.supersampling);
  const glm::dvec3 spacing = volume.geometry.spacing_mm;
  const double step_mm = settings.step_voxels * std::min({spacing.x, spacing.y, spacing.z});
  for (int y = 0; y < rays.size_px.y; ++y) {
    for (int x = 0; x < rays.size_px.x; ++x)
      rays.at({x, y}) = trace(scene, volume, ray_of(scene, {x, y}, rays.size_px), step_mm,
                              settings.picture_size_px.y);
  }
  return rays;
}

/// The mean of the rays of one pixel.
BranchPixel resolve(const Image<RayLayers>& rays, glm::ivec2 pixel, BranchLayers RayLayers::*branch,
                    int supersampling) {
  BranchPixel result;
  int met = 0;
  for (int i = 0; i < supersampling * supersampling; ++i) {
    const glm::ivec2 offset(i % supersampling, i / supersampling);
    const BranchLayers& layers = rays.at(pixel * supersampling + offset).*branch;
    result.colour += layers.colour;
    result.coverage += layers.opacity;
    result.silhouette_coverage += layers.within_outline ? 1.0 : 0.0;
    if (!layers.is_met) continue;
    result.normal += layers.nearest.normal;
    result.depth_mm += layers.nearest.distance_mm;
    result.nearest_mm = met == 0 ? layers.nearest.distance_mm
                                 : std::min(result.nearest_mm, layers.nearest.distance_mm);
    result.behind_lens += layers.is_behind_lens ? 1.0 : 0.0;
    ++met;
  }
  if (result.coverage > 0.0) result.colour /= result.coverage;
  const double count = supersampling * supersampling;
  result.coverage /= count;
  result.silhouette_coverage /= count;
  result.normal /= std::max(met, 1);
  result.depth_mm /= std::max(met, 1);
  result.behind_lens /= std::max(met, 1);
  return result;
}

void see_normals(const CameraAxes& axes, BranchImage& image) {
  for (BranchPixel& pixel : image.pixels)
    pixel.seen_normal = {glm::dot(pixel.normal, axes.right), -glm::dot(pixel.normal, axes.up),
                         glm::dot(pixel.normal, axes.backward)};
}

BranchImage draw_branch(const Scene& scene, const Branch& described, const Image<RayLayers>& rays,
                        BranchLayers RayLayers::*branch, const Settings& settings) {
  BranchImage image(settings.picture_size_px);
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x)
      image.at({x, y}) = resolve(rays, {x, y}, branch, settings.supersampling);
  }
  see_normals(camera_axes(scene.camera), image);
  for (const Module& filter : described.filters)
    image =
        apply_filter(image, in_pixels(filter, scene.viewport.height_px), settings.resolution_scale);
  return image;
}

/// The focus' share under the Magic Lens, by how near to its middle a ray passes.
double magic_weight(const Lens& lens, const ViewRay& ray) {
  const ReferenceLens body(lens);
  const Interval crossed = body.interval(ray);
  if (crossed.is_empty() || crossed.end_mm <= 0.0) return 0.0;
  const double offset = body.offset(ray);
  const double inner = 1.0 - lens.softness;
  if (offset <= inner) return lens.strength;
  const double t = (offset - inner) / lens.softness;
  return lens.strength * (1.0 - t * t * (3.0 - 2.0 * t));
}

glm::dvec3 over(const BranchPixel& front, glm::dvec3 behind) {
  return glm::mix(behind, front.colour, front.coverage);
}

glm::dvec3 composite(const Scene& scene, const BranchPixel& context, const BranchPixel& focus,
                     const ViewRay& ray) {
  const glm::dvec3 background = scene.background.colour;
  if (scene.lens.mode == LensMode::magic) {
    const glm::dvec3 plain = over(context, background);
    const glm::dvec3 behind = scene.lens.strict ? background : plain;
    return glm::mix(plain, over(focus, behind), magic_weight(scene.lens, ray));
  }
  return context.coverage * context.colour + focus.coverage * focus.colour +
         (1.0 - context.coverage - focus.coverage) * background;
}

}  // namespace

Result render(const Scene& scene, const Volume& volume, const Settings& settings) {
  Result result{cast_rays(scene, volume, settings), ColourImage(settings.picture_size_px)};
  look_again(scene, volume,
             {.supersampling = settings.supersampling,
              .rays_a_pixel = settings.resolution_scale * settings.supersampling,
              .tissues = settings.tissues,
              .light = settings.light},
             result.rays);
  const BranchImage context =
      draw_branch(scene, scene.context, result.rays, &RayLayers::context, settings);
  const BranchImage focus =
      draw_branch(scene, scene.focus, result.rays, &RayLayers::focus, settings);
  for (int y = 0; y < settings.picture_size_px.y; ++y) {
    for (int x = 0; x < settings.picture_size_px.x; ++x) {
      const ViewRay ray = ray_of(scene, {x, y}, settings.picture_size_px);
      result.picture.at({x, y}) = composite(scene, context.at({x, y}), focus.at({x, y}), ray);
    }
  }
  return result;
}

}  // namespace cutaway::reference
