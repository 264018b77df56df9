#include "render/ray_cast_pass.h"

#include <algorithm>
#include <array>

#include "core/check.h"
#include "render/lens_uniforms.h"
#include "render/shading/shading_registry.h"
#include "render/view_regions.h"

namespace cutaway {

namespace {

/// Neighbouring rays meet a surface that the lens cuts within about so many voxels of each other.
constexpr double kRimVoxels = 2.0;

constexpr glm::vec4 kNoLayer(0.0F);

const char* mode_name(LensMode mode) {
  switch (mode) {
    case LensMode::none:
      return "LENS_NONE";
    case LensMode::cutaway:
      return "LENS_CUTAWAY";
    default:
      return "LENS_MAGIC";
  }
}

void set_lens(const gl::Program& program, const Lens& lens) {
  program.set("flat_caps", lens.cap == LensCap::flat || lens.cap == LensCap::section ? 1 : 0);
  program.set("open_caps", lens.cap == LensCap::open ? 1 : 0);
  set_lens_body(program, lens);
}

void set_bands(const gl::Program& program, const RayCastKey& key, const GpuVolume& volume) {
  glm::vec2 lower;
  glm::vec2 upper;
  for (int i = 0; i < static_cast<int>(kBranches); ++i) {
    const glm::vec2 band = volume.to_stored(key.surfaces[i].band);
    lower[i] = band.x;
    upper[i] = band.y;
  }
  program.set("lower_limits", lower);
  program.set("upper_limits", upper);
}

void set_search(const gl::Program& program, const RayCastKey& key, const GpuVolume& volume) {
  const double smallest_mm = smallest_spacing_mm(volume.volume().geometry);
  program.set("ray_step_mm", static_cast<float>(key.step_voxels * smallest_mm));
  program.set("rim_mm", static_cast<float>(kRimVoxels * smallest_mm));
  program.set("skip_empty_space", key.skip_empty_space ? 1 : 0);
  set_bands(program, key, volume);
}

void set_lit_shadings(const gl::Program& program, const RayCastKey& key) {
  program.set("opacities", glm::vec2(key.surfaces[kContext].opacity, key.surfaces[kFocus].opacity));
  program.set("light_direction", key.lit->at(kContext).light_direction);
  for (const BranchIndex branch : {kContext, kFocus})
    set_shading(program, branch, key.lit->at(branch).shading);
}

}  // namespace

RayCastPass::RayCastPass(const gl::ShaderLibrary& shaders) {
  const auto add = [&](const std::string& body, LensMode mode) {
    auto definitions = lens_definitions(body);
    definitions["LENS_MODE"] = mode_name(mode);
    programs_.push_back(
        {body, mode, gl::Program(shaders, "ray_cast.vert", "ray_cast.frag", definitions),
         gl::Program(shaders, "ray_cast.vert", "ray_cast_translucent.frag", definitions)});
  };
  const std::vector<std::string> bodies = lens_body_files();
  add(bodies.front(), LensMode::none);
  for (const std::string& body : bodies) {
    add(body, LensMode::cutaway);
    add(body, LensMode::magic);
  }
}

const RayCastPass::Entry& RayCastPass::entry_for(LensMode mode, const Lens& lens) const {
  const std::string body = lens_body_file(lens);
  const auto found = std::ranges::find_if(programs_, [&](const Entry& entry) {
    return entry.mode == mode && (mode == LensMode::none || entry.body == body);
  });
  check(found != programs_.end(), "the scene's lens is one of the registry's");
  return *found;
}

void RayCastPass::clear(const RayCastKey& key, const ViewBuffers& buffers) {
  if (key.is_translucent()) {
    buffers.layers_target.clear({kNothingMet, kNothingMet, kNoLayer, kNoLayer});
  } else {
    buffers.surface_target.clear({kNothingMet, kNothingMet});
  }
}

// Most rays pass by the lens, and the program without one is simpler.
void RayCastPass::run(const RayCastKey& key, GpuVolume& volume, const ViewBuffers& buffers,
                      const gl::PixelRect& strip, const gl::PixelRect& lens,
                      const gl::FullscreenTriangle& triangle) const {
  const LensMode mode = key.lens.radius_mm > 0.0 ? key.lens.mode : LensMode::none;
  const bool is_local = mode == LensMode::cutaway && !key.funnel;
  const gl::PixelRect within = is_local ? common_part(strip, lens) : strip;
  if (!within.is_empty())
    draw(entry_for(mode, key.lens), key, volume, buffers, {{within}}, triangle);
  if (is_local)
    draw(entry_for(LensMode::none, key.lens), key, volume, buffers, parts_around(strip, lens),
         triangle);
}

void RayCastPass::draw(const Entry& entry, const RayCastKey& key, GpuVolume& volume,
                       const ViewBuffers& buffers, std::span<const gl::PixelRect> parts,
                       const gl::FullscreenTriangle& triangle) const {
  const gl::Program& program = key.is_translucent() ? entry.translucent : entry.opaque;
  program.use();
  volume.set_uniforms(program, 0);
  volume.set_empty_space(
      program, 1, volume.empty_space(key.surfaces[kContext].band, key.surfaces[kFocus].band));
  program.set_texture("entry_texture", 2, buffers.entry.name());
  set_view_rays(program, key.rays, buffers.supersampling());
  program.set("pixel_size", 2.0F * glm::length(key.rays.view_up) / key.rays.whole_px.y);
  set_search(program, key, volume);
  set_lens(program, key.lens);
  set_funnel(program, key.funnel);
  if (key.is_translucent()) set_lit_shadings(program, key);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  for (const gl::PixelRect& part : parts) {
    (key.is_translucent() ? buffers.layers_target : buffers.surface_target).bind(part);
    triangle.draw();
  }
}

}  // namespace cutaway
