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

}  // namespace

FilterPass::FilterPass(const gl::ShaderLibrary& shaders) {
  for (const ImageFilter& filter : image_filters()) {
    Entry entry{&filter, {}};
    for (const char* shader : filter.shaders)
      entry.steps.emplace_back(shaders, "fullscreen.vert", shader);
    programs_.emplace(filter.name, std::move(entry));
  }
}

int FilterPass::steps(const Module& filter) {
  return static_cast<int>(find_filter(filter.name).shaders.size());
}

int FilterPass::reach_px(const FilterKey& key) {
  return find_filter(key.filter.name).reach_px(key.filter.parameters, key.resolution_scale);
}

// Sums lie `reach` further right and down than the pixels they begin at. The first step's are those
// of whole rows below the region, too.
gl::PixelRect FilterPass::region_of_step(const FilterKey& key, int step,
                                         const gl::PixelRect& region) {
  if (step == steps(key.filter) - 1 || region.is_empty()) return region;
  const int reach = reach_px(key);
  return {region.begin, region.end + glm::ivec2(reach, step == 0 ? 2 * reach : reach)};
}

// Steps before the last fetch as many texels as they reach, or twice that.
int FilterPass::cost_of_step(const FilterKey& key, int step) {
  return step == steps(key.filter) - 1 ? 1 : 1 + reach_px(key) / 2;
}

void FilterPass::run(const FilterKey& key, int step, const FilterInput& input,
                     const FilterTarget& target, const gl::PixelRect& strip,
                     const gl::FullscreenTriangle& triangle) const {
  const Entry& entry = programs_.at(key.filter.name);
  const gl::Program& program = entry.steps.at(step);
  const int last = static_cast<int>(entry.steps.size()) - 1;
  program.use();
  program.set_texture("colour_texture", 0, input.colour.name());
  program.set_texture("silhouette_texture", 1, input.silhouette.name());
  program.set_texture("surface_texture", 2, input.surface.name());
  program.offer_texture("colour_sums", 3, target.sums.colour_sums.name());
  program.offer_texture("square_sums", 4, target.sums.square_sums.name());
  program.offer_texture("windows", 5, target.sums.windows.name());
  program.set("supersampling", input.surface.size_px().x / input.colour.size_px().x);
  program.set("is_cut", input.is_cut ? 1 : 0);
  entry.filter->set_parameters(program, key.filter.parameters, key.resolution_scale);
  const gl::Framebuffer& drawn = step == last ? target.picture : target.sums.target_of_step(step);
  drawn.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
