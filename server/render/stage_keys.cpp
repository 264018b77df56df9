#include "render/stage_keys.h"

#include <algorithm>

#include "render/filters/filter_pass.h"
#include "render/normal_taps.h"
#include "render/shading/shading_registry.h"
#include "scene/relative_lengths.h"
#include "scene/scene_fields.h"
#include "scene/scene_visit.h"
#include "scene/view_geometry.h"

namespace cutaway {

namespace {

/// The lens as far as rays are concerned: moving a slider of the composite casts none.
Lens region_of(Lens lens) {
  lens.wall = {};  // read where it is shaded
  visit_fields(lens, [](const char* name, auto& value) {
    if (is_read_only_by(OnlyReader::composite, {{"lens", {{name, nullptr}}}})) value = {};
  });
  return lens;
}

bool is_translucent(const Scene& scene) {
  return scene.context.surface.opacity < 1.0 || scene.focus.surface.opacity < 1.0;
}

}  // namespace

std::array<LitShading, kBranches> lit_shadings(const Scene& scene) {
  const glm::vec3 light = light_direction_patient(scene.light, scene.camera);
  const int height_px = scene.viewport.height_px;
  return {LitShading{in_pixels(scene.context.shading, height_px), light},
          LitShading{in_pixels(scene.focus.shading, height_px), light}};
}

RayCastKey ray_cast_key(const Scene& scene, const GpuVolume& volume,
                        const RenderSettings& settings) {
  RayCastKey key{
      .rays = in_tile(view_rays(scene.camera, scene.viewport, volume.volume().geometry), settings),
      .surfaces = {scene.context.surface, scene.focus.surface},
      .lit = {},
      .lens = region_of(scene.lens),
      .funnel = funnel_of(scene.lens, scene.camera),
      .step_voxels = settings.step_voxels,
      .skip_empty_space = settings.skip_empty_space};
  if (is_translucent(scene)) key.lit = lit_shadings(scene);
  return key;
}

namespace {

const Branch& branch_of(const Scene& scene, BranchIndex index) {
  return index == kFocus ? scene.focus : scene.context;
}

bool cuts(const Lens& lens) { return lens.mode == LensMode::cutaway && lens.radius_mm > 0.0; }

/// Twice the radius: less would leave the far side of a cavity open.
double occlusion_range_mm(const Scene& scene, const Occlusion& occlusion,
                          const VolumeGeometry& geometry) {
  constexpr double kOfDiagonal = 0.15;
  const double of_lens_mm = cuts(scene.lens) ? 2.0 * scene.lens.radius_mm : 0.0;
  return occlusion.range_mm.value_or(std::max(of_lens_mm, kOfDiagonal * diagonal_mm(geometry)));
}

/// Before which noise would stand in the surface's own light.
double light_start_mm(double normal_scale_mm, const VolumeGeometry& geometry) {
  const double largest_mm =
      std::max({geometry.spacing_mm.x, geometry.spacing_mm.y, geometry.spacing_mm.z});
  return std::max(1.5 * largest_mm, 0.5 * normal_scale_mm);
}

}  // namespace

std::optional<NormalsKey> normals_key(const Scene& scene, BranchIndex index, const RayCastKey& rays,
                                      std::uint64_t surface_version, const GpuVolume& volume) {
  const Branch& branch = branch_of(scene, index);
  const double scale_mm =
      normal_scale_mm(branch.normals, index == kFocus, volume.volume().geometry);
  const Reconstruction reconstruction = branch.normals.reconstruction;
  if (scale_mm <= 0.0 && reconstruction == Reconstruction::linear) return std::nullopt;
  return NormalsKey{surface_version, rays.rays, scale_mm, reconstruction, branch.surface.band};
}

LightKey light_key(const Scene& scene, BranchIndex index, const ViewRays& rays,
                   std::uint64_t surface_version, const GpuVolume& volume, LightQuality quality) {
  const Branch& branch = branch_of(scene, index);
  const VolumeGeometry& geometry = volume.volume().geometry;
  if (branch.occlusion.strength == 0.0) quality.directions = quality.samples = 0;
  if (branch.shadow.strength == 0.0) quality.shadow_rays = quality.shadow_samples = 0;
  const double start_mm =
      light_start_mm(normal_scale_mm(branch.normals, index == kFocus, geometry), geometry);
  const double range_mm = occlusion_range_mm(scene, branch.occlusion, geometry);
  return {.surface_version = surface_version,
          .rays = rays,
          .bands = {scene.context.surface.band, scene.focus.surface.band},
          .lens = region_of(scene.lens),
          .funnel = funnel_of(scene.lens, scene.camera),
          .light_direction = light_direction_patient(scene.light, scene.camera),
          .start_mm = static_cast<float>(start_mm),
          .range_mm = static_cast<float>(std::max(range_mm, 2.0 * start_mm)),
          .near_share = static_cast<float>(branch.occlusion.near_share),
          .shadow_softness_degrees = static_cast<float>(branch.shadow.softness_degrees),
          .shadow_range_mm = static_cast<float>(0.5 * diagonal_mm(geometry)),
          .quality = quality};
}

Relief relief_of(const Scene& scene, BranchIndex index, std::uint64_t reach_version) {
  const Branch& branch = branch_of(scene, index);
  return {reach_version, branch.occlusion.strength, branch.occlusion.colour,
          branch.shadow.strength};
}

std::optional<CavityWall> cavity_wall(const Scene& scene) {
  const Lens& lens = scene.lens;
  const bool section = lens.cap == LensCap::section;
  const bool has_tone =
      lens.wall.strength > 0.0 || lens.wall.deepening > 0.0 || lens.wall.edge_mm > 0.0;
  if (!section && !(cuts(lens) && has_tone)) return std::nullopt;
  return CavityWall{lens.wall, section, scene.context.surface.band, lens.centre_mm,
                    std::max(lens.radius_mm, 1e-3)};
}

std::optional<MagicLens> magic_lens(const Scene& scene, const ViewRays& rays) {
  if (scene.lens.mode != LensMode::magic) return std::nullopt;
  return MagicLens{scene.lens, rays};
}

namespace {

FilterPlan plan_of(const Module& filter, const Scene& scene, double resolution_scale) {
  return FilterPass::plan({.filter = in_pixels(filter, scene.viewport.height_px),
                           .resolution_scale = resolution_scale});
}

}  // namespace

WorkNeeds work_needs(const Scene& scene, double resolution_scale) {
  WorkNeeds needs;
  for (const Branch* branch : {&scene.context, &scene.focus}) {
    for (const Module& filter : branch->filters)
      needs.add(FilterPass::work_needs(plan_of(filter, scene, resolution_scale)));
  }
  return needs;
}

namespace {

bool has_calm_normals(const Branch& branch) {
  return branch.normals.scale == NormalScale::automatic || branch.normals.scale_mm > 0.0 ||
         branch.normals.reconstruction == Reconstruction::cubic;
}

bool has_light(const Branch& branch, const RenderSettings& settings) {
  return (branch.occlusion.strength > 0.0 && settings.light.directions > 0) ||
         (branch.shadow.strength > 0.0 && settings.light.shadow_rays > 0);
}

}  // namespace

BufferNeeds needs_of(const Scene& scene, const RenderSettings& settings) {
  return {.picture_size_px = settings.picture_size_px,
          .supersampling = settings.supersampling,
          .layout = settings.layout,
          .casts_rays = scene.viewport.kind == ViewKind::volume,
          .is_translucent = is_translucent(scene),
          .filters = {scene.context.filters.size(), scene.focus.filters.size()},
          .calmed = {has_calm_normals(scene.context), has_calm_normals(scene.focus)},
          .reach = {has_light(scene.context, settings), has_light(scene.focus, settings)},
          .work = work_needs(scene, settings.resolution_scale)};
}

int tile_margin_px(const Scene& scene) {
  constexpr int kRegions_px = 3;  // what a region's margin reads beside a pixel
  constexpr int kTurning_px = 1;  // what the next ray's normal is read from
  int margin_px = 0;
  for (const Branch* branch : {&scene.context, &scene.focus}) {
    const bool has_reach = branch->occlusion.strength > 0.0 || branch->shadow.strength > 0.0;
    int of_branch_px = has_reach ? LightPass::kReach_px : 0;
    if (reads_turning(in_pixels(branch->shading, scene.viewport.height_px)))
      of_branch_px = std::max(of_branch_px, kTurning_px);
    for (const Module& filter : branch->filters)
      of_branch_px += plan_of(filter, scene, 1.0).reach_px + kRegions_px;
    margin_px = std::max(margin_px, of_branch_px);
  }
  return margin_px;
}

}  // namespace cutaway
