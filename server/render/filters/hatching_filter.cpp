// See hatching.glsl.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "render/filters/brightness_steps.h"
#include "render/filters/flow.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

enum Shader { kGround, kTurning, kBlur, kFlow, kCurved, kParallel };
constexpr std::array kShaders = {
    "hatching_ground.frag", "hatching_turning.frag", "blur.frag",
    "hatching_flow.frag",   "hatching_curved.frag",  "hatching_parallel.frag"};

constexpr WorkTexture kForms{WorkFormat::rgba32f, 0};
constexpr WorkTexture kNoises{WorkFormat::rgba32f, 1};
constexpr WorkTexture kTensor{WorkFormat::rgba32f, 2};
constexpr WorkTexture kRows{WorkFormat::rgba32f, 3};
constexpr WorkTexture kFlows = kRows;  // which are done with by then

/// Of a stroke's length, by what the turning is smoothed.
constexpr double kSmoothingShare = 0.3;
/// Samples of the noise on a way lie no farther apart, in widths, unless that is less than a pixel,
/// but are no more than these.
constexpr double kSampleWidths = 0.6;
constexpr int kMostSamples = 32;

struct Strokes {
  double width_px;
  double length_px;  ///< never shorter than two widths: dots are no strokes
  int samples;       ///< on the way to either end
  double step_px;
};

Strokes strokes_of(const Json& parameters, double resolution_scale) {
  const double width_px = length_px(parameters, "width", resolution_scale);
  const double whole_px =
      std::max(length_px(parameters, "length", resolution_scale), 2.0 * width_px);
  const int samples = std::clamp(
      static_cast<int>(std::ceil(0.5 * whole_px / std::max(kSampleWidths * width_px, 1.0))), 1,
      kMostSamples);
  return {width_px, whole_px, samples, 0.5 * whole_px / samples};
}

/// Of the noise, that many pairs of widths apart: of windows that are half a cosine long, and of
/// waves that go all ways.
double correlation(double apart) {
  if (apart >= 2.0) return 0.0;
  const double half = glm::half_pi<double>() * apart;
  const double windows = 0.5 * (2.0 - apart) * std::cos(half) + std::sin(half) / glm::pi<double>();
  return windows * std::cyl_bessel_j(0.0, glm::two_pi<double>() * apart);
}

double weight(int sample, const Strokes& strokes) {
  const double fade = std::cos(glm::half_pi<double>() * sample / (strokes.samples + 1));
  return fade * fade;
}

/// Of the sum that hatching_curved.frag makes, on a straight way.
double deviation_of(const Strokes& strokes) {
  if (strokes.width_px == 0.0) return 1.0;
  const double step = strokes.step_px / (2.0 * strokes.width_px);
  double variance = 0.0;
  for (int apart = 0; apart <= 2 * strokes.samples; ++apart) {
    double weights = 0.0;
    for (int i = -strokes.samples; i + apart <= strokes.samples; ++i)
      weights += weight(i, strokes) * weight(i + apart, strokes);
    variance += (apart == 0 ? 1.0 : 2.0) * weights * correlation(apart * step);
  }
  return std::sqrt(variance);
}

FilterPlan plan(const Json& parameters, double resolution_scale) {
  const Strokes strokes = strokes_of(parameters, resolution_scale);
  const bool follows = is_choice(parameters, "direction", "curvature") && strokes.width_px > 0.0;
  if (!follows) return chained({{.shader = kParallel, .writes = {}, .reads = {}, .cost = 4}});
  const double smoothing_px = kSmoothingShare * strokes.length_px;
  return chained({{.shader = kGround, .writes = {kForms, kNoises}, .reads = {}, .cost = 4},
                  {.shader = kTurning,
                   .writes = {kTensor},
                   .reads = {{"forms", kForms}},
                   .reach_px = 1,
                   .cost = 2},
                  blur_step(kBlur, kTensor, kRows, {1, 0}, smoothing_px),
                  blur_step(kBlur, kRows, kTensor, {0, 1}, smoothing_px),
                  {.shader = kFlow,
                   .writes = {kFlows},
                   .reads = {{"forms", kForms}, {"tensor", kTensor}},
                   .reach_px = 0,
                   .cost = 2},
                  {.shader = kCurved,
                   .writes = {},
                   .reads = {{"flows", kFlows}, {"noises", kNoises}},
                   .reach_px = static_cast<int>(std::ceil(0.5 * strokes.length_px)) + 1,
                   .cost = 4 + 2 * strokes.samples}});
}

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  const Strokes strokes = strokes_of(parameters, resolution_scale);
  program.offer("width_px", static_cast<float>(strokes.width_px));
  program.offer("length_px", static_cast<float>(strokes.length_px));
  program.offer("steps", strokes.samples);
  program.offer("step_px", static_cast<float>(strokes.step_px));
  program.offer("deviation", static_cast<float>(deviation_of(strokes)));
  program.offer("angle", glm::radians(number(parameters, "angle_degrees")));
  program.offer("cross_from", number(parameters, "cross_from"));
  program.offer("wall_darker", number(parameters, "wall_darker"));
  program.offer("ink", colour(parameters, "ink"));
  program.offer("paper", colour(parameters, "paper"));
  program.offer("wash", number(parameters, "wash"));
  program.offer("strength", number(parameters, "strength"));
}

}  // namespace

extern const ImageFilter kHatchingFilter{"hatching", kShaders, plan, set_parameters};

}  // namespace cutaway
