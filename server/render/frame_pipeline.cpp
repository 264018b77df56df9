#include "render/frame_pipeline.h"

#include "core/check.h"
#include "render/shaders.h"
#include "scene/view_geometry.h"

namespace cutaway {

namespace {

/// The lens as far as rays are concerned: moving a slider of the composite casts none.
Lens region_of(const Lens& lens) {
  const Lens defaults;
  Lens region = lens;
  region.strength = defaults.strength;
  region.softness = defaults.softness;
  region.strict = defaults.strict;
  return region;
}

std::array<Look, kBranches> looks_of(const Scene& scene) {
  const glm::vec3 light = light_direction_patient(scene.light, scene.camera);
  return {Look{scene.context.shading, light}, Look{scene.focus.shading, light}};
}

RayCastKey ray_cast_key(const Scene& scene, const GpuVolume& volume,
                        const RenderSettings& settings) {
  RayCastKey key{.volume = volume.identity(),
                 .rays = view_rays(scene.camera, scene.viewport, volume.volume().geometry),
                 .surfaces = {scene.context.surface, scene.focus.surface},
                 .looks = {},
                 .lens = region_of(scene.lens),
                 .step_voxels = settings.step_voxels,
                 .skip_empty_space = settings.skip_empty_space};
  if (scene.context.surface.opacity < 1.0 || scene.focus.surface.opacity < 1.0)
    key.looks = looks_of(scene);
  return key;
}

std::optional<MagicLens> magic_lens(const Scene& scene, const ViewRays& rays) {
  if (scene.lens.mode != LensMode::magic) return std::nullopt;
  return MagicLens{scene.lens, rays};
}

std::vector<glm::vec4> texels_of(const gl::Texture2D& texture) {
  const glm::ivec2 size = texture.size_px();
  std::vector<glm::vec4> values(static_cast<std::size_t>(size.x) * size.y);
  glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(values.size() * sizeof(glm::vec4)), values.data());
  return values;
}

}  // namespace

StageCounts ViewState::counts() const {
  StageCounts counts{.ray_cast = ray_cast_.runs(), .composite = composite_.runs()};
  for (std::size_t i = 0; i < kBranches; ++i) {
    counts.shade[i] = branches_[i].shade.runs();
    for (const auto& filter : branches_[i].filters) counts.filters[i] += filter.runs();
  }
  return counts;
}

FramePipeline::FramePipeline()
    : shaders_(shader_library()),
      ray_cast_pass_(shaders_),
      shade_pass_(shaders_),
      resolve_pass_(shaders_),
      filter_pass_(shaders_),
      composite_pass_(shaders_),
      convert_pass_(shaders_) {}

void FramePipeline::render(ViewState& view, const Scene& scene, GpuVolume& volume,
                           const RenderSettings& settings) {
  if (!view.buffers_ || !view.buffers_->fits(settings)) {
    view = ViewState();
    view.buffers_.emplace(settings.picture_size_px, settings.supersampling);
  }
  const RayCastKey rays = ray_cast_key(scene, volume, settings);
  const ViewRegions regions =
      view_regions(scene, volume.volume().geometry, settings.picture_size_px);
  const std::uint64_t surface = cast_rays(view, rays, volume, regions.volume);
  const auto looks = looks_of(scene);
  const auto branch = [&](BranchIndex index, const Branch& described) {
    const Target target{regions.branches[index], settings};
    const auto shaded = rays.is_translucent()
                            ? resolve(view, index, surface, target)
                            : shade(view, index, {surface, rays.rays, looks[index]}, target);
    return filter(view, index, described.filters, shaded, target);
  };
  const auto context = branch(kContext, scene.context);
  const auto focus = branch(kFocus, scene.focus);
  composite(view, {context.version, focus.version, context.texture, focus.texture, scene.background,
                   magic_lens(scene, rays.rays)});
  convert(view, settings.layout);
}

std::uint64_t FramePipeline::cast_rays(ViewState& view, const RayCastKey& key, GpuVolume& volume,
                                       const gl::PixelRect& region) {
  return view.ray_cast_.run(key, [&] {
    ray_cast_pass_.run(key, volume, *view.buffers_, scaled(region, view.buffers_->supersampling()),
                       triangle_);
    ran("ray cast");
  });
}

ViewState::BranchPicture FramePipeline::shade(ViewState& view, BranchIndex index,
                                              const ShadeKey& key, const Target& target) {
  const BranchBuffers& buffers = view.buffers_->branches[index];
  const std::uint64_t version = view.branches_[index].shade.run(key, [&] {
    shade_pass_.run(key, index, buffers, target.region, target.settings.supersampling, triangle_);
    ran("shade");
  });
  return {&buffers.shaded, version};
}

ViewState::BranchPicture FramePipeline::resolve(ViewState& view, BranchIndex index,
                                                std::uint64_t layers_version,
                                                const Target& target) {
  const BranchBuffers& buffers = view.buffers_->branches[index];
  const ShadeKey key{.surface_version = layers_version, .rays = {}, .look = {}};
  const std::uint64_t version = view.branches_[index].shade.run(key, [&] {
    resolve_pass_.run(buffers, target.region, target.settings.supersampling, triangle_);
    ran("resolve");
  });
  return {&buffers.shaded, version};
}

ViewState::BranchPicture FramePipeline::filter(ViewState& view, BranchIndex index,
                                               const std::vector<Module>& filters,
                                               ViewState::BranchPicture picture,
                                               const Target& target) {
  const BranchBuffers& buffers = view.buffers_->branches[index];
  auto& stages = view.branches_[index].filters;
  const std::uint64_t shaded = picture.version;
  if (stages.size() < filters.size()) stages.resize(filters.size());
  for (std::size_t i = 0; i < filters.size(); ++i) {
    const ColourTarget& output = view.buffers_->filtered(index, i);
    const FilterKey key{picture.version, shaded, filters[i], target.settings.resolution_scale};
    picture.version = stages[i].run(key, [&] {
      filter_pass_.run(key, {*picture.texture, buffers.silhouette, buffers.surface},
                       output.framebuffer, target.region, triangle_);
      ran(filters[i].name.c_str());
    });
    picture.texture = &output.texture;
  }
  return picture;
}

void FramePipeline::composite(ViewState& view, const CompositeKey& key) {
  view.composite_.run(key, [&] {
    composite_pass_.run(key, view.buffers_->picture.framebuffer, triangle_);
    ran("composite");
  });
}

void FramePipeline::convert(ViewState& view, PixelLayout layout) {
  if (layout == PixelLayout::rgba) return;
  view.buffers_->prepare_planes(layout);
  convert_pass_.run(layout, *view.buffers_, triangle_);
  ran("convert");
}

void FramePipeline::ran(const char* stage) const {
  if (observer_) observer_(stage);
}

void FramePipeline::start_readback(const ViewState& view, PixelLayout layout,
                                   gl::PixelReadback& readback) {
  check(view.buffers_.has_value(), "a view was rendered before it is read back");
  readback.start(readback_sources(layout, *view.buffers_));
}

std::vector<glm::vec4> FramePipeline::read_surface(const ViewState& view, BranchIndex branch) {
  return texels_of(view.buffers_->branches[branch].surface);
}

std::vector<glm::vec4> FramePipeline::read_layers(const ViewState& view, BranchIndex branch) {
  return texels_of(view.buffers_->branches[branch].layers);
}

glm::ivec2 FramePipeline::surface_size_px(const ViewState& view) {
  return view.buffers_->surface_size_px();
}

}  // namespace cutaway
