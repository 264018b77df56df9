#include "render/frame_pipeline.h"

#include "core/check.h"
#include "render/shaders.h"
#include "scene/view_geometry.h"

namespace cutaway {

namespace {

RayCastKey ray_cast_key(const Scene& scene, const GpuVolume& volume,
                        const RenderSettings& settings) {
  return {.volume = volume.identity(),
          .rays = view_rays(scene.camera, scene.viewport, volume.volume().geometry),
          .context_iso_value = scene.context.iso_value,
          .focus_iso_value = scene.focus.iso_value,
          .lens = scene.lens,
          .step_voxels = settings.step_voxels,
          .skip_empty_space = settings.skip_empty_space};
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
    : shaders_(embedded_shaders()),
      ray_cast_pass_(shaders_),
      shade_pass_(shaders_),
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
  const std::uint64_t surface = cast_rays(view, rays, volume);
  const glm::vec3 light = light_direction_patient(scene.light, scene.camera);
  const auto context = draw_branch(view, kContext, scene.context,
                                   {surface, rays.rays, scene.context.shading, light}, settings);
  const auto focus = draw_branch(view, kFocus, scene.focus,
                                 {surface, rays.rays, scene.focus.shading, light}, settings);
  composite(view, scene, context, focus);
  convert(view, settings.layout);
}

std::uint64_t FramePipeline::cast_rays(ViewState& view, const RayCastKey& key, GpuVolume& volume) {
  return view.ray_cast_.run(key, [&] {
    ray_cast_pass_.run(key, volume, *view.buffers_, triangle_);
    ran("ray cast");
  });
}

ViewState::BranchPicture FramePipeline::draw_branch(ViewState& view, BranchIndex index,
                                                    const Branch& branch, const ShadeKey& key,
                                                    const RenderSettings& settings) {
  const BranchBuffers& buffers = view.buffers_->branches[index];
  ViewState::Branch& stages = view.branches_[index];
  const std::uint64_t shaded = stages.shade.run(key, [&] {
    shade_pass_.run(key, buffers, settings.supersampling, triangle_);
    ran("shade");
  });
  ViewState::BranchPicture picture{&buffers.shaded, shaded};
  if (stages.filters.size() < branch.filters.size()) stages.filters.resize(branch.filters.size());
  for (std::size_t i = 0; i < branch.filters.size(); ++i) {
    const ColourTarget& target = view.buffers_->filtered(index, i);
    const FilterKey filter{picture.version, shaded, branch.filters[i], settings.resolution_scale};
    picture.version = stages.filters[i].run(filter, [&] {
      filter_pass_.run(filter, *picture.texture, buffers.silhouette, target.framebuffer, triangle_);
      ran(branch.filters[i].name.c_str());
    });
    picture.texture = &target.texture;
  }
  return picture;
}

void FramePipeline::composite(ViewState& view, const Scene& scene,
                              const ViewState::BranchPicture& context,
                              const ViewState::BranchPicture& focus) {
  const CompositeKey key{context.version, focus.version, context.texture, focus.texture,
                         scene.background};
  view.composite_.run(key, [&] {
    composite_pass_.run(scene.background, *context.texture, *focus.texture,
                        view.buffers_->picture.framebuffer, triangle_);
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
  const gl::Texture2D& surface = view.buffers_->branches[branch].surface;
  const glm::ivec2 size = surface.size_px();
  std::vector<glm::vec4> values(static_cast<std::size_t>(size.x) * size.y);
  glGetTextureImage(surface.name(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(values.size() * sizeof(glm::vec4)), values.data());
  return values;
}

glm::ivec2 FramePipeline::surface_size_px(const ViewState& view) {
  return view.buffers_->surface_size_px();
}

}  // namespace cutaway
