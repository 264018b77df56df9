#include "support/reference_looks.h"

#include <algorithm>
#include <cmath>

#include "scene/relative_lengths.h"
#include "support/reference_normals.h"
#include "support/reference_pixels.h"
#include "support/reference_shading.h"

namespace cutaway::reference {

namespace {

/// One of the two, in the scene and in the rays.
struct BranchView {
  BranchName name;
  const Branch& described;
  BranchLayers RayLayers::*layers;
};

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

void calm(const Scene& scene, const Volume& volume, const BranchView& branch,
          Image<RayLayers>& rays) {
  for (int i = 0; i < rays.size_px.x * rays.size_px.y; ++i) {
    const glm::ivec2 at(i % rays.size_px.x, i / rays.size_px.x);
    BranchLayers& layers = rays.at(at).*branch.layers;
    if (layers.is_met)
      layers.nearest = calmed(layers.nearest, branch.described, branch.name, volume,
                              ray_of(scene, at, rays.size_px));
  }
}

class Looks {
 public:
  Looks(const Scene& scene, const Volume& volume, const LookSettings& settings,
        const BranchView& branch, const Image<RayLayers>& rays, const Image<glm::dvec2>& reach)
      : scene_(scene),
        volume_(volume),
        settings_(settings),
        branch_(branch),
        shading_(in_pixels(branch.described.shading, scene.viewport.height_px)),
        to_light_(light_direction_patient(scene.light, scene.camera)),
        rays_(rays),
        reach_(reach) {}

  glm::dvec3 colour(glm::ivec2 at) const {
    const BranchLayers& layers = rays_.at(at).*branch_.layers;
    const ViewRay ray = ray_of(scene_, at, rays_.size_px);
    const glm::dvec2 reach = reach_.at(at / settings_.supersampling);
    const double light_share = 1.0 - branch_.described.shadow.strength * (1.0 - reach.y);
    glm::dvec3 colour = shaded(at, layers, ray, light_share);
    if (branch_.name == BranchName::context && has_wall(scene_))
      colour = wall(scene_, volume_, settings_.tissues, layers, ray, colour);
    const Occlusion& occlusion = branch_.described.occlusion;
    const glm::dvec3 kept = glm::mix(occlusion.colour, glm::dvec3(1.0), reach.x);
    return colour * glm::mix(glm::dvec3(1.0), kept, occlusion.strength);
  }

 private:
  glm::dvec3 shaded(glm::ivec2 at, const BranchLayers& layers, const ViewRay& ray,
                    double light_share) const {
    if (shading_.parameters.value("softness", 0.0) == 0.0)
      return shade(shading_, layers.nearest.normal, to_light_, -ray.direction, light_share);
    const double ray_mm =
        ray_spacing_mm(scene_.camera, rays_.size_px.y, layers.nearest.distance_mm);
    return shade_turning(shading_, layers.nearest.normal, to_light_,
                         turning(rays_, at, {1, 0}, branch_.layers, ray_mm),
                         turning(rays_, at, {0, 1}, branch_.layers, ray_mm), settings_.rays_a_pixel,
                         light_share);
  }

  const Scene& scene_;
  const Volume& volume_;
  const LookSettings& settings_;
  const BranchView& branch_;
  Module shading_;
  glm::dvec3 to_light_;
  const Image<RayLayers>& rays_;
  const Image<glm::dvec2>& reach_;
};

Image<glm::dvec2> reach_of(const Scene& scene, const Volume& volume, const LookSettings& settings,
                           const BranchView& branch, const Image<RayLayers>& rays) {
  const Branch& described = branch.described;
  if (described.occlusion.strength > 0.0 || described.shadow.strength > 0.0)
    return light_reach(scene, volume, ReferenceCopy(volume), rays, branch.name,
                       settings.supersampling, settings.light);
  Image<glm::dvec2> all(rays.size_px / settings.supersampling);
  std::ranges::fill(all.pixels, glm::dvec2(1.0));
  return all;
}

}  // namespace

void look_again(const Scene& scene, const Volume& volume, const LookSettings& settings,
                Image<RayLayers>& rays) {
  if (scene.context.surface.opacity < 1.0 || scene.focus.surface.opacity < 1.0) return;
  const BranchView branches[] = {{BranchName::context, scene.context, &RayLayers::context},
                                 {BranchName::focus, scene.focus, &RayLayers::focus}};
  for (const BranchView& branch : branches) {
    if (asks_for_other_normals(branch.described.normals)) calm(scene, volume, branch, rays);
    const auto reach = reach_of(scene, volume, settings, branch, rays);
    const Looks looks(scene, volume, settings, branch, rays, reach);
    for (int i = 0; i < rays.size_px.x * rays.size_px.y; ++i) {
      const glm::ivec2 at(i % rays.size_px.x, i / rays.size_px.x);
      BranchLayers& layers = rays.at(at).*branch.layers;
      if (layers.is_met) layers.colour = looks.colour(at);
    }
  }
}

}  // namespace cutaway::reference
