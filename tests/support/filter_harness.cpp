#include "support/filter_harness.h"

#include <cmath>
#include <random>

#include "render/filters/filter_pass.h"
#include "render/shaders.h"
#include "render/view_buffers.h"
#include "scene/schema.h"
#include "support/gpu_harness.h"

namespace cutaway::test {

using reference::BranchImage;
using reference::BranchPixel;

namespace {

template <typename Texel, typename Function>
std::vector<Texel> texels_of(const BranchImage& image, Function&& function) {
  std::vector<Texel> texels;
  texels.reserve(image.pixels.size());
  for (const BranchPixel& pixel : image.pixels) texels.push_back(function(pixel));
  return texels;
}

Module filter(const Json& document) {
  Module module{document.at("name"), document};
  module.parameters.erase("name");
  return module;
}

/// Right and down are the first two axes.
const ViewRays kFromAbove{.eye_mm = glm::vec3(0.0F),
                          .view_forward = {0.0F, 0.0F, -1.0F},
                          .view_right = {1.0F, 0.0F, 0.0F},
                          .view_up = {0.0F, -1.0F, 0.0F},
                          .is_perspective = false,
                          .patient_to_volume = glm::mat3(1.0F),
                          .eye_in_volume = glm::vec3(0.0F)};

}  // namespace

double representable(double value) { return std::round(value * 1024.0) / 1024.0; }

BranchImage filtered_on_gpu(const BranchImage& input, const Module& filter) {
  GpuHarness::instance();
  FilterPass pass{shader_library()};
  const gl::FullscreenTriangle triangle;
  const glm::ivec2 size = input.size_px;
  const gl::Texture2D colour(GL_RGBA16F, size, gl::Filtering::nearest);
  const gl::Texture2D silhouette(GL_R8, size, gl::Filtering::nearest);
  const gl::Texture2D output(GL_RGBA32F, size, gl::Filtering::nearest);
  const gl::Framebuffer target({&output});
  const auto colours = texels_of<glm::vec4>(
      input, [](const BranchPixel& p) { return glm::vec4(p.colour, p.coverage); });
  const auto coverages = texels_of<float>(
      input, [](const BranchPixel& p) { return static_cast<float>(p.silhouette_coverage); });
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(colour.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, colours.data());
  glTextureSubImage2D(silhouette.name(), 0, 0, 0, size.x, size.y, GL_RED, GL_FLOAT,
                      coverages.data());
  const gl::Texture2D surface(GL_RGBA32F, size, gl::Filtering::nearest);
  const auto surfaces = texels_of<glm::vec4>(input, [](const BranchPixel& p) {
    const double length = p.behind_lens > 0.0 ? 2.0 : 1.0;
    return glm::vec4(length * p.normal, p.coverage > 0.0 ? p.depth_mm : -1.0);
  });
  glTextureSubImage2D(surface.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, surfaces.data());
  const FilterKey key{.filter = filter};
  const gl::PixelRect whole{{0, 0}, size};
  const FilterPlan plan = FilterPass::plan(key);
  const FilterWork work(FilterPass::work_needs(plan), size);
  for (const FilterStep& step : plan.steps)
    pass.run(key, step, {colour, silhouette, surface, true, kFromAbove}, {target, work},
             FilterPass::region_of_step(step, whole, size), triangle);
  std::vector<glm::vec4> result(input.pixels.size());
  glGetTextureImage(output.name(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(result.size() * sizeof(glm::vec4)), result.data());
  BranchImage image = input;
  for (std::size_t i = 0; i < result.size(); ++i) {
    image.pixels[i].colour = glm::dvec3(result[i]);
    image.pixels[i].coverage = result[i].a;
  }
  return image;
}

Module filter_module(const char* name, const Json& parameters) {
  Json module = {{"name", name}};
  module.update(parameters);
  Json scene = {{"context", {{"filters", Json::array({std::move(module)})}}}};
  return filter(with_defaults(std::move(scene), "scene").at("context").at("filters").at(0));
}

Module kuwahara(int radius) { return filter({{"name", "kuwahara"}, {"radius", radius}}); }

Module sobel(double strength, const char* mode, const char* norm, const char* gradient,
             const char* source, bool silhouettes) {
  return filter({{"name", "sobel"},
                 {"strength", strength},
                 {"mode", mode},
                 {"source", source},
                 {"silhouettes", silhouettes},
                 {"depth_step_mm", 50.0},
                 {"norm", norm},
                 {"gradient", gradient}});
}

BranchImage grey(glm::ivec2 size, const std::function<double(int, int)>& level) {
  BranchImage image(size);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) image.at({x, y}) = {glm::dvec3(level(x, y)), 1.0, 1.0};
  }
  return image;
}

BranchImage turned(const BranchImage& image) {
  BranchImage result({image.size_px.y, image.size_px.x});
  for (int y = 0; y < result.size_px.y; ++y) {
    for (int x = 0; x < result.size_px.x; ++x)
      result.at({x, y}) = image.at({y, image.size_px.y - 1 - x});
  }
  return result;
}

BranchImage random_picture(unsigned seed, glm::ivec2 size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  BranchImage image(size);
  for (BranchPixel& pixel : image.pixels) {
    const double kind = level(random);
    if (kind < 0.15) continue;
    if (kind < 0.25) {
      pixel.silhouette_coverage = 1.0;
      continue;
    }
    pixel = {
        {representable(level(random)), representable(level(random)), representable(level(random))},
        1.0,
        1.0,
        glm::normalize(glm::dvec3(level(random), level(random), level(random)) - 0.4),
        300.0 + 40.0 * level(random),
        level(random) < 0.3 ? 1.0 : 0.0};
    pixel.seen_normal = pixel.normal;
    pixel.nearest_mm = pixel.depth_mm;
  }
  return image;
}

}  // namespace cutaway::test
