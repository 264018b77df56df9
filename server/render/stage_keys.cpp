#include "render/stage_keys.h"

#include <algorithm>

#include "render/filters/filter_pass.h"
#include "render/shading/shading_registry.h"
#include "scene/relative_lengths.h"
#include "scene/scene_fields.h"
#include "scene/scene_visit.h"
#include "scene/view_geometry.h"

namespace cutaway {

namespace {

/// The lens as far as rays are concerned: moving a slider of the composite casts none.
Lens region_of(Lens lens) {
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
      .step_voxels = settings.step_voxels,
      .skip_empty_space = settings.skip_empty_space};
  if (is_translucent(scene)) key.lit = lit_shadings(scene);
  return key;
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

BufferNeeds needs_of(const Scene& scene, const RenderSettings& settings) {
  return {.picture_size_px = settings.picture_size_px,
          .supersampling = settings.supersampling,
          .layout = settings.layout,
          .casts_rays = scene.viewport.kind == ViewKind::volume,
          .is_translucent = is_translucent(scene),
          .filters = {scene.context.filters.size(), scene.focus.filters.size()},
          .work = work_needs(scene, settings.resolution_scale)};
}

int tile_margin_px(const Scene& scene) {
  constexpr int kRegions_px = 3;  // what a region's margin reads beside a pixel
  constexpr int kTurning_px = 1;  // what the next ray's normal is read from
  int margin_px = 0;
  for (const Branch* branch : {&scene.context, &scene.focus}) {
    int of_branch_px =
        reads_turning(in_pixels(branch->shading, scene.viewport.height_px)) ? kTurning_px : 0;
    for (const Module& filter : branch->filters)
      of_branch_px += plan_of(filter, scene, 1.0).reach_px + kRegions_px;
    margin_px = std::max(margin_px, of_branch_px);
  }
  return margin_px;
}

}  // namespace cutaway
