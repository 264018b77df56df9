// See anisotropic_kuwahara.frag.
#include <array>

#include "render/filters/flow.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

enum Shader { kBlurColours, kBlur, kTensor, kSectors };
constexpr std::array kShaders = {"blur_colours.frag", "blur.frag", "structure_tensor.frag",
                                 "anisotropic_kuwahara.frag"};

constexpr WorkTexture kRows{WorkFormat::rgba32f, 0};
constexpr WorkTexture kBlurred{WorkFormat::rgba32f, 1};
constexpr WorkTexture kTensorOfPixel{WorkFormat::rgba32f, 0};
constexpr WorkTexture kTensorRows{WorkFormat::rgba32f, 2};

/// Of the radius: about half of the distance of the places that are looked at, and what the tensor
/// is smoothed by.
constexpr double kBlurShare = 0.12;
constexpr double kSmoothingShare = 1.0 / 3.0;

FilterPlan plan(const Json& parameters, double resolution_scale) {
  const double radius_px = number(parameters, "radius") * resolution_scale;
  const bool follows = number(parameters, "anisotropy") > 0.0F;
  if (radius_px == 0.0) return chained({{.shader = kSectors, .writes = {}, .reads = {}}});
  const double blur_px = kBlurShare * radius_px;
  const double smoothing_px = kSmoothingShare * radius_px;
  std::vector<FilterStep> steps = {blur_step(kBlurColours, kRows, kRows, {1, 0}, blur_px),
                                   blur_step(kBlur, kRows, kBlurred, {0, 1}, blur_px)};
  steps.front().reads.clear();
  FilterStep sectors{.shader = kSectors,
                     .writes = {},
                     .reads = {{"blurred", kBlurred}},
                     .reach_px = static_cast<int>((follows ? 2.0 : 1.0) * radius_px) + 1,
                     .cost = 12};
  if (follows) {
    steps.push_back({.shader = kTensor,
                     .writes = {kTensorOfPixel},
                     .reads = {{"blurred", kBlurred}},
                     .reach_px = 1,
                     .cost = 3});
    steps.push_back(blur_step(kBlur, kTensorOfPixel, kTensorRows, {1, 0}, smoothing_px));
    steps.push_back(blur_step(kBlur, kTensorRows, kTensorOfPixel, {0, 1}, smoothing_px));
    sectors.reads.emplace_back("tensor", kTensorOfPixel);
  }
  steps.push_back(std::move(sectors));
  return chained(std::move(steps));
}

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  program.offer("radius_px", number(parameters, "radius") * static_cast<float>(resolution_scale));
  program.offer("anisotropy", number(parameters, "anisotropy"));
  program.offer("sharpness", number(parameters, "sharpness"));
}

}  // namespace

extern const ImageFilter kAnisotropicKuwaharaFilter{"anisotropic_kuwahara", kShaders, plan,
                                                    set_parameters};

}  // namespace cutaway
