#include "support/reference_renderer.h"

#include <algorithm>
#include <cmath>

#include "scene/relative_lengths.h"
#include "scene/view_geometry.h"
#include "support/reference_filters.h"
#include "support/reference_shading.h"

namespace cutaway::reference {

namespace {

ViewRay ray_of(const Scene& scene, glm::ivec2 at, glm::ivec2 size_px) {
  const glm::dvec2 viewport(scene.viewport.width_px, scene.viewport.height_px);
  return ray_through(scene.camera, scene.viewport,
                     (glm::dvec2(at) + 0.5) * viewport / glm::dvec2(size_px));
}

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

/// Another ray of the same surface, as far as depths tell.
bool is_beside(const Image<RayLayers>& rays, glm::ivec2 there, const BranchLayers& here,
               BranchLayers RayLayers::*branch, double ray_mm) {
  if (!rays.contains(there)) return false;
  const BranchLayers& other = rays.at(there).*branch;
  return other.is_met &&
         std::abs(other.nearest.distance_mm - here.nearest.distance_mm) < 4.0 * ray_mm;
}

glm::dvec3 turning(const Image<RayLayers>& rays, glm::ivec2 at, glm::ivec2 along,
                   BranchLayers RayLayers::*branch, double ray_mm) {
  const BranchLayers& here = rays.at(at).*branch;
  glm::dvec3 sum(0.0);
  int sides = 0;
  for (const int side : {-1, 1}) {
    if (!is_beside(rays, at + side * along, here, branch, ray_mm)) continue;
    const glm::dvec3 there = (rays.at(at + side * along).*branch).nearest.normal;
    sum += double(side) * (there - here.nearest.normal);
    ++sides;
  }
  return sum / std::max(double(sides), 1.0);
}

/// Of neighbouring rays, at that distance.
double ray_spacing_mm(const Camera& camera, int rays_high, double distance_mm) {
  return camera.projection == Projection::orthographic
             ? camera.view_height_mm / rays_high
             : 2.0 * std::tan(0.5 * glm::radians(camera.vertical_fov_degrees)) * distance_mm /
                   rays_high;
}

/// Shades again where the branch's tone has a soft step: of that the neighbours' normals are part.
void soften(const Scene& scene, const Branch& described, BranchLayers RayLayers::*branch,
            const Settings& settings, Image<RayLayers>& rays) {
  const Module shading = in_pixels(described.shading, scene.viewport.height_px);
  const bool is_layered = scene.context.surface.opacity < 1.0 || scene.focus.surface.opacity < 1.0;
  if (is_layered || shading.parameters.value("softness", 0.0) == 0.0) return;
  const glm::dvec3 to_light = light_direction_patient(scene.light, scene.camera);
  for (int y = 0; y < rays.size_px.y; ++y) {
    for (int x = 0; x < rays.size_px.x; ++x) {
      BranchLayers& layers = rays.at({x, y}).*branch;
      if (!layers.is_met) continue;
      const double ray_mm =
          ray_spacing_mm(scene.camera, rays.size_px.y, layers.nearest.distance_mm);
      layers.colour = shade_turning(shading, layers.nearest.normal, to_light,
                                    turning(rays, {x, y}, {1, 0}, branch, ray_mm),
                                    turning(rays, {x, y}, {0, 1}, branch, ray_mm),
                                    settings.resolution_scale * settings.supersampling);
    }
  }
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
  soften(scene, scene.context, &RayLayers::context, settings, result.rays);
  soften(scene, scene.focus, &RayLayers::focus, settings, result.rays);
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
