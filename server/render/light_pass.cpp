#include "render/light_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/check.h"
#include "render/lens_uniforms.h"

namespace cutaway {

namespace {

/// What is in the way is looked for in a copy of the volume whose noise does not cast shadows.
constexpr std::size_t kLevel = 1;

/// Sunflower seeds: evenly over the unit disc. Projected up, they are directions weighted by their
/// cosine. Source: H. Vogel, "A better way to construct the sunflower head", 1979.
glm::vec2 disc_point(int number, int count) {
  constexpr double kGoldenAngle = 2.399963229728653;
  const double radius = std::sqrt((number + 0.5) / count);
  return {radius * std::cos(number * kGoldenAngle), radius * std::sin(number * kGoldenAngle)};
}

std::string body_of(const LightKey& key) {
  const bool cuts = key.lens.mode == LensMode::cutaway && key.lens.radius_mm > 0.0;
  return cuts ? lens_body_file(key.lens) : std::string();
}

gl::Program light_program(const gl::ShaderLibrary& shaders, BranchIndex branch,
                          const std::string& body) {
  std::map<std::string, std::string> definitions = {
      {"BRANCH", branch == kFocus ? "FOCUS" : "CONTEXT"},
      {"MOST_DIRECTIONS", std::to_string(kMostLightDirections)},
      {"CUTAWAY", body.empty() ? "0" : "1"}};
  definitions.merge(lens_definitions(body.empty() ? lens_body_files().front() : body));
  return {shaders, "rays.vert", "light_reach.frag", definitions};
}

}  // namespace

LightPass::LightPass(const gl::ShaderLibrary& shaders)
    : blur_(shaders, "fullscreen.vert", "light_blur.frag") {
  std::vector<std::string> bodies = lens_body_files();
  bodies.emplace_back();
  for (const BranchIndex branch : {kContext, kFocus})
    for (const std::string& body : bodies)
      programs_.push_back({branch, body, light_program(shaders, branch, body)});
}

const gl::Program& LightPass::program_for(const LightKey& key, BranchIndex branch) const {
  const auto found = std::ranges::find_if(programs_, [&, body = body_of(key)](const Entry& entry) {
    return entry.branch == branch && entry.body == body;
  });
  check(found != programs_.end(), "there is a program for each lens body");
  return found->program;
}

void LightPass::run(const LightKey& key, int step, BranchIndex index, const GpuVolume& volume,
                    const BranchBuffers& branch, const gl::Texture2D& surface,
                    const gl::PixelRect& strip, int supersampling,
                    const gl::FullscreenTriangle& triangle) const {
  if (step == 0)
    march(key, index, volume, surface, supersampling);
  else
    blur(key, branch, surface, supersampling);
  (step == 0 ? branch.reach_raw : branch.reach).framebuffer.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

void LightPass::march(const LightKey& key, BranchIndex index, const GpuVolume& volume,
                      const gl::Texture2D& surface, int supersampling) const {
  const gl::Program& program = program_for(key, index);
  program.use();
  program.set_texture("surface_texture", 0, surface.name());
  volume.set_level(program, 1, std::min(kLevel, volume.coarse_levels()));
  program.set("supersampling", supersampling);
  for (std::size_t i = 0; i < kBranches; ++i)
    program.set(("bands[" + std::to_string(i) + "]").c_str(), volume.to_stored(key.bands[i]));
  program.set("start_mm", key.start_mm);
  program.set("range_mm", key.range_mm);
  program.set("near_share", key.near_share);
  program.set("directions", key.quality.directions);
  program.set("samples", key.quality.samples);
  for (int i = 0; i < key.quality.directions; ++i)
    program.set(("disc[" + std::to_string(i) + "]").c_str(), disc_point(i, key.quality.directions));
  program.set("shadow_rays", key.quality.shadow_rays);
  program.set("shadow_samples", key.quality.shadow_samples);
  program.set("shadow_spread", std::tan(glm::radians(key.shadow_softness_degrees)));
  program.set("shadow_range_mm", key.shadow_range_mm);
  program.set("light_direction", key.light_direction);
  set_view_rays(program, key.rays);
  if (body_of(key).empty()) return;
  set_lens_body(program, key.lens);
  set_funnel(program, key.funnel);
}

void LightPass::blur(const LightKey& key, const BranchBuffers& branch, const gl::Texture2D& surface,
                     int supersampling) const {
  blur_.use();
  blur_.set_texture("surface_texture", 0, surface.name());
  blur_.set_texture("reach_texture", 1, branch.reach_raw.texture.name());
  blur_.set("supersampling", supersampling);
  blur_.set("pixel_size", 2.0F * glm::length(key.rays.view_up) / key.rays.whole_px.y);
  blur_.set("is_perspective", key.rays.is_perspective ? 1 : 0);
}

}  // namespace cutaway
