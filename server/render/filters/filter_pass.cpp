#include "render/filters/filter_pass.h"

#include <algorithm>

#include "core/check.h"
#include "render/filters/filter_registry.h"

namespace cutaway {

namespace {

const ImageFilter& find_filter(const std::string& name) {
  const auto filters = image_filters();
  const auto found = std::ranges::find(filters, name, &ImageFilter::name);
  check(found != filters.end(), "the scene's filter is one of the registry's");
  return *found;
}

/// For filters that ask from where a surface is seen, or for places of the whole picture.
void offer_view(const gl::Program& program, const ViewRays& rays) {
  program.offer("view_right", glm::normalize(rays.view_right));
  program.offer("view_down", -glm::normalize(rays.view_up));
  program.offer("view_backward", -rays.view_forward);
  program.offer("first_px", rays.first_px);
}

}  // namespace

FilterPass::FilterPass(const gl::ShaderLibrary& shaders) {
  for (const ImageFilter& filter : image_filters()) {
    Entry entry{&filter, {}};
    for (const char* shader : filter.shaders)
      entry.programs.emplace_back(shaders, "fullscreen.vert", shader);
    programs_.emplace(filter.name, std::move(entry));
  }
}

FilterPlan FilterPass::plan(const FilterKey& key) {
  return find_filter(key.filter.name).plan(key.filter.parameters, key.resolution_scale);
}

WorkNeeds FilterPass::work_needs(const FilterPlan& plan) {
  WorkNeeds needs;
  for (const FilterStep& step : plan.steps)
    for (const WorkTexture& texture : step.writes) needs.add(texture, step.beyond_px);
  return needs;
}

gl::PixelRect FilterPass::region_of_step(const FilterStep& step, const gl::PixelRect& region,
                                         glm::ivec2 picture_size_px) {
  if (region.is_empty()) return region;
  return {glm::max(region.begin - step.before_px, glm::ivec2(0)),
          glm::min(region.end + step.further_px, picture_size_px + step.beyond_px)};
}

void FilterPass::run(const FilterKey& key, const FilterStep& step, const FilterInput& input,
                     const FilterTarget& target, const gl::PixelRect& strip,
                     const gl::FullscreenTriangle& triangle) const {
  const Entry& entry = programs_.at(key.filter.name);
  const gl::Program& program = entry.programs.at(step.shader);
  program.use();
  program.set_texture("colour_texture", 0, input.colour.name());
  program.set_texture("silhouette_texture", 1, input.silhouette.name());
  program.set_texture("surface_texture", 2, input.surface.name());
  int unit = 3;
  for (const auto& [name, texture] : step.reads)
    program.set_texture(name, unit++, target.work.texture(texture).name());
  program.set("supersampling", input.surface.size_px().x / input.colour.size_px().x);
  program.set("is_cut", input.is_cut ? 1 : 0);
  offer_view(program, input.rays);
  if (step.along != glm::ivec2(0)) program.set("along", step.along);
  entry.filter->set_parameters(program, key.filter.parameters, key.resolution_scale);
  for (const auto& [name, value] : step.numbers) program.set(name, value);
  const gl::Framebuffer& drawn =
      step.writes.empty() ? target.picture : target.work.target(step.writes);
  drawn.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
