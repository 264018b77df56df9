// See fdog.frag.
#include <array>
#include <cmath>

#include "render/filters/brightness_steps.h"
#include "render/filters/flow.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

enum Shader { kRows, kColumns, kTensor, kBlur, kAcross, kLines };
constexpr std::array kShaders = {"brightness_rows.frag",   "brightness_columns.frag",
                                 "brightness_tensor.frag", "blur.frag",
                                 "fdog_across.frag",       "fdog.frag"};

constexpr WorkTexture kTensorOfPixel{WorkFormat::rgba32f, 2};

/// By what the tensor is smoothed, in sigmas: lines keep their way over gaps of about as much.
constexpr double kSmoothing = 2.0;

FilterPlan plan(const Json& parameters, double resolution_scale) {
  const double sigma_px = length_px(parameters, "sigma", resolution_scale);
  const double along_px = length_px(parameters, "length", resolution_scale);
  if (sigma_px == 0.0) return chained({{.shader = kLines, .writes = {}, .reads = {}}});
  const int across_px = wide_reach_px(sigma_px);
  const int way_px = static_cast<int>(std::ceil(2.0 * along_px)) + 1;
  std::vector<FilterStep> steps = scale_steps(kRows, sigma_px);
  steps.push_back({.shader = kTensor,
                   .writes = {kTensorOfPixel},
                   .reads = {{"scales", kScales}},
                   .reach_px = 1,
                   .cost = 3});
  const double smoothing_px = kSmoothing * sigma_px;
  steps.push_back(blur_step(kBlur, kTensorOfPixel, kScratch, {1, 0}, smoothing_px));
  steps.push_back(blur_step(kBlur, kScratch, kTensorOfPixel, {0, 1}, smoothing_px));
  steps.push_back({.shader = kAcross,
                   .writes = {kScratch},
                   .reads = {{"tensor", kTensorOfPixel}, {"scales", kScales}},
                   .reach_px = across_px,
                   .cost = 2 + 2 * across_px});
  steps.push_back({.shader = kLines,
                   .writes = {},
                   .reads = {{"tensor", kTensorOfPixel}, {"across", kScratch}, {"scales", kScales}},
                   .reach_px = way_px,
                   .cost = 2 + 4 * way_px});
  return chained(std::move(steps));
}

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  offer_ink(program, parameters, resolution_scale);
  program.offer("length_px", static_cast<float>(length_px(parameters, "length", resolution_scale)));
  program.offer("tau", number(parameters, "tau"));
  program.offer("hardness", number(parameters, "hardness"));
}

}  // namespace

extern const ImageFilter kFdogFilter{"fdog", kShaders, plan, set_parameters};

}  // namespace cutaway
