#include "render/frame_pipeline.h"

#include "core/check.h"
#include "render/shaders.h"
#include "render/stage_keys.h"
#include "scene/relative_lengths.h"

namespace cutaway {

namespace {

/// No coverage.
constexpr glm::vec4 kNothing(0.0F);

/// Of a ray, in units of a pixel of a simple pass.
constexpr int kRayCost = 4;
constexpr int kNormalsCost = 2;

constexpr glm::vec4 kAllLight(1.0F);

/// Where versions of normals at a scale begin.
constexpr std::uint64_t kCalmedVersions = std::uint64_t{1} << 63U;

/// Of a point's light, in units of a pixel of a simple pass.
int cost_of(const LightQuality& quality) {
  return 1 +
         ((quality.directions * quality.samples) + (quality.shadow_rays * quality.shadow_samples)) /
             8;
}

/// The region of a pass that is drawn as one.
constexpr gl::PixelRect kIndivisible{{0, 0}, {1, 1}};

std::vector<glm::vec4> texels_of(const gl::Texture2D& texture) {
  const glm::ivec2 size = texture.size_px();
  std::vector<glm::vec4> values(static_cast<std::size_t>(size.x) * size.y);
  glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(values.size() * sizeof(glm::vec4)), values.data());
  return values;
}

}  // namespace

StageCounts ViewState::counts() const {
  StageCounts counts{.entry = entry_.runs(),
                     .ray_cast = ray_cast_.runs(),
                     .composite = composite_.runs(),
                     .slice = slice_.runs(),
                     .convert = convert_.runs()};
  for (std::size_t i = 0; i < kBranches; ++i) {
    counts.normals[i] = branches_[i].normals.runs();
    counts.light[i] = branches_[i].light.runs();
    counts.shade[i] = branches_[i].shade.runs();
    for (const auto& filter : branches_[i].filters) counts.filters[i] += filter.runs();
  }
  return counts;
}

FramePipeline::FramePipeline()
    : shaders_(shader_library()),
      entry_pass_(shaders_),
      ray_cast_pass_(shaders_),
      normals_pass_(shaders_),
      light_pass_(shaders_),
      shade_pass_(shaders_),
      resolve_pass_(shaders_),
      filter_pass_(shaders_),
      composite_pass_(shaders_),
      slice_pass_(shaders_),
      convert_pass_(shaders_) {}

FramePlan FramePipeline::plan(ViewState& view, const Scene& scene, GpuVolume& volume,
                              const RenderSettings& settings) {
  const ViewKind kind = scene.viewport.kind;
  if (!view.buffers_ || !view.buffers_->fits(settings) || view.kind_ != kind) {
    view = ViewState();
    view.kind_ = kind;
    view.buffers_.emplace(settings.picture_size_px, settings.supersampling);
  }
  FramePlan plan(observer_);
  const std::uint64_t picture = kind == ViewKind::volume
                                    ? picture_of_volume(view, scene, volume, settings, plan)
                                    : picture_of_slice(view, scene, volume, settings, plan);
  if (settings.layout != PixelLayout::rgba) convert(view, {picture, settings.layout}, plan);
  return plan;
}

std::uint64_t FramePipeline::picture_of_volume(ViewState& view, const Scene& scene,
                                               GpuVolume& volume, const RenderSettings& settings,
                                               FramePlan& plan) {
  view.buffers_->prepare_rays();
  view.buffers_->prepare_work(work_needs(scene, settings.resolution_scale));
  const VolumeGeometry part =
      settings.skip_empty_space
          ? volume.occupied_part(scene.context.surface.band, scene.focus.surface.band)
          : volume.volume().geometry;
  RayCastKey rays = ray_cast_key(scene, volume, settings);
  const Draft draft{view,
                    *view.buffers_,
                    settings,
                    view_regions(scene, part, settings),
                    scene.viewport.height_px,
                    rays.rays,
                    plan};
  rays.entry_version = find_entries(draft, rays, volume);
  const std::uint64_t surface = cast_rays(draft, rays, volume);
  const auto branch = [&](BranchIndex index, const Branch& described) {
    BranchPicture met{&view.buffers_->branches[index].surface, surface};
    if (rays.is_translucent())
      return filter(draft, index, described.filters, resolve(draft, index, surface), *met.texture);
    if (const auto key = normals_key(scene, index, rays, surface, volume))
      met = calm_normals(draft, index, *key, volume);
    const auto shaded = shade_surface(draft, index, scene, met, rays.rays, volume);
    return filter(draft, index, described.filters, shaded, *met.texture);
  };
  const auto context = branch(kContext, scene.context);
  const auto focus = branch(kFocus, scene.focus);
  return composite(draft, {context.version, focus.version, context.texture, focus.texture,
                           scene.background, magic_lens(scene, rays.rays)});
}

std::uint64_t FramePipeline::picture_of_slice(ViewState& view, const Scene& scene,
                                              const GpuVolume& volume,
                                              const RenderSettings& settings, FramePlan& plan) {
  const SliceKey key = slice_key(scene, volume, settings);
  const ViewBuffers& buffers = *view.buffers_;
  return view.slice_.schedule(key, plan,
                              {.name = "slice",
                               .region = {{0, 0}, buffers.picture_size_px()},
                               .begin = {},
                               .draw = [this, key, &volume, &buffers](const gl::PixelRect& strip) {
                                 slice_pass_.run(key, volume, buffers.picture.framebuffer, strip,
                                                 triangle_);
                               }});
}

std::uint64_t FramePipeline::find_entries(const Draft& draft, const RayCastKey& rays,
                                          GpuVolume& volume) {
  const EntryKey key =
      entry_key(volume, rays.rays, {rays.surfaces[kContext].band, rays.surfaces[kFocus].band},
                rays.skip_empty_space);
  const ViewBuffers& buffers = draft.buffers;
  return draft.view.entry_.schedule(key, draft.plan,
                                    {.name = "entry",
                                     .region = kIndivisible,
                                     .begin = {},
                                     .draw = [this, key, &volume, &buffers](const gl::PixelRect&) {
                                       entry_pass_.run(key, volume, buffers);
                                     }});
}

std::uint64_t FramePipeline::cast_rays(const Draft& draft, const RayCastKey& key,
                                       GpuVolume& volume) {
  ViewBuffers& buffers = draft.buffers;
  if (key.is_translucent()) buffers.prepare_layers();
  return draft.view.ray_cast_.schedule(
      key, draft.plan,
      {.name = kRayCast,
       .region = scaled(draft.regions.volume, draft.settings.supersampling),
       .cost = kRayCost,
       .begin = [key, &buffers] { RayCastPass::clear(key, buffers); },
       .draw =
           [this, key, &volume, &buffers,
            lens = scaled(draft.regions.branches[kFocus], draft.settings.supersampling)](
               const gl::PixelRect& strip) {
             ray_cast_pass_.run(key, volume, buffers, strip, lens, triangle_);
           }});
}

FramePipeline::BranchPicture FramePipeline::calm_normals(const Draft& draft, BranchIndex index,
                                                         const NormalsKey& key,
                                                         const GpuVolume& volume) {
  draft.buffers.prepare_calmed(index);
  const BranchBuffers& buffers = draft.buffers.branches[index];
  const int rays = draft.settings.supersampling;
  const std::uint64_t version = draft.view.branches_[index].normals.schedule(
      key, draft.plan,
      {.name = "normals",
       .region = scaled(draft.regions.branches[index], rays),
       .cost = kNormalsCost,
       .begin = [&buffers] { buffers.calmed_target.clear({kNothingMet}); },
       .draw =
           [this, key, rays, &buffers, &volume](const gl::PixelRect& strip) {
             normals_pass_.run(key, volume, buffers, strip, rays, triangle_);
           }});
  // Apart from the versions of the ray cast, which may come to stand in its place.
  return {&buffers.calmed, kCalmedVersions + version};
}

std::uint64_t FramePipeline::reach_of_light(const Draft& draft, BranchIndex index,
                                            const LightKey& key, const gl::Texture2D& surface,
                                            const GpuVolume& volume) {
  draft.buffers.prepare_reach(index);
  const BranchBuffers& buffers = draft.buffers.branches[index];
  std::vector<Pass> steps;
  steps.reserve(LightPass::kSteps);
  for (int step = 0; step < LightPass::kSteps; ++step)
    steps.push_back({.name = "light",
                     .region = draft.regions.branches[index],
                     .cost = step == 0 ? cost_of(key.quality) : 1,
                     .begin =
                         [step, &buffers] {
                           const auto& target = step == 0 ? buffers.reach_raw : buffers.reach;
                           target.framebuffer.clear({kAllLight});
                         },
                     .draw =
                         [this, key, step, index, &volume, &buffers, &surface,
                          rays = draft.settings.supersampling](const gl::PixelRect& strip) {
                           light_pass_.run(key, step, index, volume, buffers, surface, strip, rays,
                                           triangle_);
                         }});
  return draft.view.branches_[index].light.schedule(key, draft.plan, std::move(steps));
}

FramePipeline::BranchPicture FramePipeline::shade_surface(const Draft& draft, BranchIndex index,
                                                          const Scene& scene, BranchPicture surface,
                                                          const ViewRays& rays,
                                                          const GpuVolume& volume) {
  ShadeKey key{.surface_version = surface.version,
               .rays = rays,
               .lit = lit_shadings(scene)[index],
               .relief = {},
               .wall = index == kContext ? cavity_wall(scene) : std::nullopt,
               .resolution_scale = draft.settings.resolution_scale};
  const LightKey light =
      light_key(scene, index, rays, surface.version, volume, draft.settings.light);
  if (light.is_asked())
    key.relief =
        relief_of(scene, index, reach_of_light(draft, index, light, *surface.texture, volume));
  return shade(draft, index, key, *surface.texture, volume);
}

FramePipeline::BranchPicture FramePipeline::shade(const Draft& draft, BranchIndex index,
                                                  const ShadeKey& key, const gl::Texture2D& surface,
                                                  const GpuVolume& volume) {
  const BranchBuffers& buffers = draft.buffers.branches[index];
  const std::uint64_t version = draft.view.branches_[index].shade.schedule(
      key, draft.plan,
      {.name = "shade",
       .region = draft.regions.branches[index],
       .begin =
           [&buffers] {
             buffers.shade_target.clear({kNothing, kNothing});
           },
       .draw =
           [this, key, index, &buffers, &surface, &volume,
            rays = draft.settings.supersampling](const gl::PixelRect& strip) {
             shade_pass_.run(key, index, volume, buffers, surface, strip, rays, triangle_);
           }});
  return {&buffers.shaded, version};
}

FramePipeline::BranchPicture FramePipeline::resolve(const Draft& draft, BranchIndex index,
                                                    std::uint64_t layers_version) {
  const BranchBuffers& buffers = draft.buffers.branches[index];
  const ShadeKey key{.surface_version = layers_version, .rays = {}, .lit = {}};
  const std::uint64_t version = draft.view.branches_[index].shade.schedule(
      key, draft.plan,
      {.name = "resolve",
       .region = draft.regions.branches[index],
       .begin =
           [&buffers] {
             buffers.shade_target.clear({kNothing, kNothing});
           },
       .draw =
           [this, &buffers, rays = draft.settings.supersampling](const gl::PixelRect& strip) {
             resolve_pass_.run(buffers, strip, rays, triangle_);
           }});
  return {&buffers.shaded, version};
}

FramePipeline::BranchPicture FramePipeline::filter(const Draft& draft, BranchIndex index,
                                                   const std::vector<Module>& filters,
                                                   BranchPicture picture,
                                                   const gl::Texture2D& surface) {
  auto& stages = draft.view.branches_[index].filters;
  const std::uint64_t shaded = picture.version;
  while (stages.size() < filters.size()) stages.emplace_back();
  for (std::size_t i = 0; i < filters.size(); ++i) {
    const ColourTarget& target = draft.buffers.filtered(index, i);
    const FilterKey key{picture.version, shaded, in_pixels(filters[i], draft.viewport_height_px),
                        draft.settings.resolution_scale};
    picture.version = stages[i].schedule(
        key, draft.plan, filter_steps(draft, index, key, *picture.texture, surface, target));
    picture.texture = &target.texture;
  }
  return picture;
}

std::vector<Pass> FramePipeline::filter_steps(const Draft& draft, BranchIndex index,
                                              const FilterKey& key, const gl::Texture2D& input,
                                              const gl::Texture2D& surface,
                                              const ColourTarget& target) {
  const BranchBuffers& buffers = draft.buffers.branches[index];
  const FilterWork& work = draft.buffers.work();
  const gl::PixelRect region = draft.regions.branches[index];
  std::vector<Pass> steps;
  for (const FilterStep& step : FilterPass::plan(key).steps) {
    steps.push_back(
        {.name = key.filter.name,
         .region = FilterPass::region_of_step(step, region, draft.buffers.picture_size_px()),
         .cost = step.cost,
         .begin = {},
         .draw = [this, key, step, &buffers, &work, &input, &surface, &target,
                  is_cut = index == kContext, rays = draft.rays](const gl::PixelRect& strip) {
           filter_pass_.run(key, step,
                            {.colour = input,
                             .silhouette = buffers.silhouette,
                             .surface = surface,
                             .is_cut = is_cut,
                             .rays = rays},
                            {target.framebuffer, work}, strip, triangle_);
         }});
  }
  steps.back().begin = [&target] { target.framebuffer.clear({kNothing}); };
  return steps;
}

std::uint64_t FramePipeline::composite(const Draft& draft, const CompositeKey& key) {
  const ViewBuffers& buffers = draft.buffers;
  return draft.view.composite_.schedule(key, draft.plan,
                                        {.name = "composite",
                                         .region = {{0, 0}, buffers.picture_size_px()},
                                         .begin = {},
                                         .draw = [this, key, &buffers](const gl::PixelRect& strip) {
                                           composite_pass_.run(key, buffers.picture.framebuffer,
                                                               strip, triangle_);
                                         }});
}

// Its planes differ in size, so it is drawn as one; it is the cheapest pass.
void FramePipeline::convert(ViewState& view, const ConvertKey& key, FramePlan& plan) {
  ViewBuffers& buffers = *view.buffers_;
  buffers.prepare_planes(key.layout);
  view.convert_.schedule(key, plan,
                         {.name = "convert",
                          .region = kIndivisible,
                          .begin = {},
                          .draw = [this, layout = key.layout, &buffers](const gl::PixelRect&) {
                            convert_pass_.run(layout, buffers, triangle_);
                          }});
}

void FramePipeline::start_readback(const ViewState& view, PixelLayout layout,
                                   gl::PixelReadback& readback) {
  check(view.buffers_.has_value(), "a view was rendered before it is read back");
  readback.start(readback_sources(layout, *view.buffers_));
}

std::vector<glm::vec4> FramePipeline::read_surface(const ViewState& view, BranchIndex branch) {
  return texels_of(view.buffers_->branches[branch].surface);
}

std::vector<glm::vec4> FramePipeline::read_calmed(const ViewState& view, BranchIndex branch) {
  return texels_of(view.buffers_->branches[branch].calmed);
}

std::vector<glm::vec4> FramePipeline::read_reach(const ViewState& view, BranchIndex branch) {
  return texels_of(view.buffers_->branches[branch].reach.texture);
}

std::vector<glm::vec4> FramePipeline::read_shaded(const ViewState& view, BranchIndex branch) {
  return texels_of(view.buffers_->branches[branch].shaded);
}

std::vector<glm::vec4> FramePipeline::read_layers(const ViewState& view, BranchIndex branch) {
  return texels_of(view.buffers_->branches[branch].layers);
}

glm::ivec2 FramePipeline::surface_size_px(const ViewState& view) {
  return view.buffers_->surface_size_px();
}

}  // namespace cutaway
