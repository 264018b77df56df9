// Filters on pictures with a known answer, and on random ones against the reference.
#include <gtest/gtest.h>

#include <random>

#include "render/filters/filter_pass.h"
#include "render/shaders.h"
#include "render/view_buffers.h"
#include "support/gpu_harness.h"
#include "support/reference_filters.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;
using reference::BranchPixel;

/// Numbers that a half float holds exactly, so that both sides start from the same picture.
double representable(double value) { return std::round(value * 1024.0) / 1024.0; }

template <typename Texel, typename Function>
std::vector<Texel> texels_of(const BranchImage& image, Function&& function) {
  std::vector<Texel> texels;
  for (const BranchPixel& pixel : image.pixels) texels.push_back(function(pixel));
  return texels;
}

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
    return glm::vec4(p.normal, p.coverage > 0.0 ? p.depth_mm : -1.0);
  });
  glTextureSubImage2D(surface.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, surfaces.data());
  pass.run({.filter = filter}, {colour, silhouette, surface}, target, {{0, 0}, size}, triangle);
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

Module filter(const Json& document) {
  Module module{document.at("name"), document};
  module.parameters.erase("name");
  return module;
}

Module kuwahara(int radius) { return filter({{"name", "kuwahara"}, {"radius", radius}}); }

Module sobel(double strength, const char* mode, const char* norm = "raw",
             const char* gradient = "l1", const char* source = "colour", bool silhouettes = true) {
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

TEST(Kuwahara, AnIsolatedPixelIsSpreadOverItsQuadrantAndNowhereElse) {
  for (const int radius : {1, 2, 3, 5}) {
    const auto input = grey({31, 31}, [](int x, int y) { return x == 15 && y == 15 ? 1.0 : 0.0; });
    const BranchImage output = filtered_on_gpu(input, kuwahara(radius));
    for (int y = 0; y < 31; ++y) {
      for (int x = 0; x < 31; ++x) {
        const double expected = x == 15 && y == 15 ? 1.0 / ((radius + 1) * (radius + 1)) : 0.0;
        EXPECT_NEAR(output.at({x, y}).colour.r, expected, 1e-3)
            << radius << " at " << x << "," << y;
      }
    }
  }
}

TEST(Kuwahara, ARampDoesNotShift) {
  for (const int radius : {1, 2, 5}) {
    const auto input = grey({41, 15}, [](int x, int) { return x / 64.0; });
    const BranchImage output = filtered_on_gpu(input, kuwahara(radius));
    for (int x = radius; x < 41 - radius; ++x)
      EXPECT_NEAR(output.at({x, 7}).colour.r, x / 64.0, 1e-4) << radius;
  }
}

TEST(Kuwahara, StraightStepsAndCornersStayAsTheyAre) {
  const auto step = grey({21, 21}, [](int x, int) { return x < 10 ? 0.25 : 0.75; });
  const auto corner = grey({21, 21}, [](int x, int y) { return x < 10 && y < 10 ? 0.25 : 0.75; });
  for (const BranchImage& input : {step, corner}) {
    const BranchImage output = filtered_on_gpu(input, kuwahara(3));
    for (std::size_t i = 0; i < input.pixels.size(); ++i)
      EXPECT_NEAR(output.pixels[i].colour.r, input.pixels[i].colour.r, 1e-4);
  }
}

TEST(Kuwahara, TheBackgroundNeitherBleedsInNorMoves) {
  auto input = grey({21, 21}, [](int, int) { return 0.5; });
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 9; ++x) input.at({x, y}) = {};
  }
  const BranchImage output = filtered_on_gpu(input, kuwahara(4));
  for (int x = 0; x < 21; ++x) {
    EXPECT_EQ(output.at({x, 10}).coverage, x < 9 ? 0.0 : 1.0);
    if (x >= 9) {
      EXPECT_NEAR(output.at({x, 10}).colour.r, 0.5, 1e-4);
    }
  }
}

TEST(Sobel, RespondsWithTheKnownNumbers) {
  // Unit norm and a small step keep below the clamp: a step of 0.1 along an axis gives 4 * 0.1 / 4.
  const auto step = grey({12, 12}, [](int x, int) { return x < 6 ? 0.5 : 0.6; });
  const BranchImage edge = filtered_on_gpu(step, sobel(1.0, "brighten", "unit"));
  for (int x = 1; x < 11; ++x) {
    const double added = x == 5 || x == 6 ? 0.1 : 0.0;
    EXPECT_NEAR(edge.at({x, 6}).colour.r, (x < 6 ? 0.5 : 0.6) + added, 2e-3) << x;
  }
  const auto ramp = grey({12, 12}, [](int x, int) { return 0.2 + x / 256.0; });
  EXPECT_NEAR(filtered_on_gpu(ramp, sobel(1.0, "brighten")).at({6, 6}).colour.r,
              0.2 + 6 / 256.0 + 8 / 256.0, 2e-3);
}

BranchImage turned(const BranchImage& image) {
  BranchImage result({image.size_px.y, image.size_px.x});
  for (int y = 0; y < result.size_px.y; ++y) {
    for (int x = 0; x < result.size_px.x; ++x)
      result.at({x, y}) = image.at({y, image.size_px.y - 1 - x});
  }
  return result;
}

TEST(Sobel, OfATurnedPictureIsTheTurnedPicture) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  const auto input = grey({20, 14}, [&](int, int) { return representable(level(random)); });
  const BranchImage one = turned(filtered_on_gpu(input, sobel(0.7, "darken", "unit")));
  const BranchImage other = filtered_on_gpu(turned(input), sobel(0.7, "darken", "unit"));
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
    EXPECT_NEAR(one.pixels[i].colour.r, other.pixels[i].colour.r, 1e-6);
}

TEST(Sobel, DarkAndBrightLinesAreEquallyFarFromThePicture) {
  const auto input = grey({16, 16}, [](int x, int y) { return 0.5 + 0.02 * ((x * y) % 3); });
  const BranchImage dark = filtered_on_gpu(input, sobel(0.7, "darken", "unit"));
  const BranchImage bright = filtered_on_gpu(input, sobel(0.7, "brighten", "unit"));
  for (std::size_t i = 0; i < input.pixels.size(); ++i) {
    const double mean = 0.5 * (dark.pixels[i].colour.r + bright.pixels[i].colour.r);
    EXPECT_NEAR(mean, input.pixels[i].colour.r, 1e-3);
  }
}

TEST(Sobel, StrengthZeroChangesNothing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  const auto input = grey({16, 16}, [&](int, int) { return representable(level(random)); });
  const BranchImage output = filtered_on_gpu(input, sobel(0.0, "darken"));
  for (std::size_t i = 0; i < input.pixels.size(); ++i)
    EXPECT_EQ(output.pixels[i].colour, input.pixels[i].colour);
}

TEST(Sobel, DrawsTheSilhouetteButNotTheLensRim) {
  auto input = grey({20, 20}, [](int, int) { return 0.5; });
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 5; ++x) input.at({x, y}) = {};  // background
    for (int x = 15; x < 20; ++x)
      input.at({x, y}) = {glm::dvec3(0.0), 0.0, 1.0};  // taken by the lens
  }
  const BranchImage output = filtered_on_gpu(input, sobel(1.0, "darken"));
  EXPECT_NEAR(output.at({5, 10}).colour.r, 0.0, 1e-3);
  EXPECT_NEAR(output.at({10, 10}).colour.r, 0.5, 1e-3);
  EXPECT_NEAR(output.at({14, 10}).colour.r, 0.5, 1e-3);
}

/// Random colours in patches, with background and lens regions of random shape.
BranchImage random_picture(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  BranchImage image({48, 40});
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
        300.0 + 40.0 * level(random)};
  }
  return image;
}

TEST(Filters, AreTheReferencesOnRandomPictures) {
  const std::vector<Module> filters{kuwahara(0),
                                    kuwahara(1),
                                    kuwahara(3),
                                    kuwahara(7),
                                    sobel(0.7, "darken"),
                                    sobel(1.0, "brighten", "unit", "l2"),
                                    sobel(0.4, "multiply", "raw", "l2"),
                                    sobel(0.7, "darken", "unit", "l2", "luma", false),
                                    sobel(0.7, "darken", "unit", "l1", "depth"),
                                    sobel(0.7, "brighten", "unit", "l2", "depth", false),
                                    sobel(0.6, "darken", "unit", "l1", "normal", false)};
  for (const Module& module : filters) {
    for (const unsigned seed : {1U, 2U}) {
      const BranchImage input = random_picture(seed);
      const BranchImage actual = filtered_on_gpu(input, module);
      const BranchImage expected = reference::apply_filter(input, module, 1.0);
      for (std::size_t i = 0; i < input.pixels.size(); ++i) {
        if (expected.pixels[i].coverage == 0.0) continue;
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(actual.pixels[i].colour[c], expected.pixels[i].colour[c], 1.0 / 255.0)
              << module.name << module.parameters << " pixel " << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace cutaway::test
