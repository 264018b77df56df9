// A change of one branch's picture after shading and before the composite.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "gl/program.h"
#include "render/filters/filter_work.h"
#include "scene/json.h"

namespace cutaway {

/// One fragment shader, drawn once.
struct FilterStep {
  int shader = 0;  ///< of the filter's
  /// What it leaves for later steps, in the order of its outputs; the last step draws the picture.
  std::vector<WorkTexture> writes;
  /// What it takes from steps before: the sampler's name, and the texture.
  std::vector<std::pair<const char*, WorkTexture>> reads;
  int reach_px = 0;     ///< how far beside a pixel it looks into what it reads
  glm::ivec2 along{0};  ///< set as `along` unless 0: the way of a step that goes one way
  std::vector<std::pair<const char*, float>> numbers{};  ///< uniforms as this step has them
  glm::ivec2 beyond_px{0};   ///< how much larger than the picture what it writes is
  glm::ivec2 further_px{0};  ///< how much more than its picture's region is drawn, right and down
  glm::ivec2 before_px{0};   ///< the same, left and up
  int cost = 1;              ///< of a pixel, in units of a simple pass' pixel
};

/// What is drawn, in order.
struct FilterPlan {
  std::vector<FilterStep> steps;
  int reach_px = 0;  ///< how far beside a pixel the whole of it looks
};

/// Of steps that each need what those before them left in a margin of their reach.
FilterPlan chained(std::vector<FilterStep> steps);

/// One registry entry: fragment shaders over filter.glsl, in which steps they are drawn, and how
/// their uniforms follow from the module's parameters. `resolution_scale` is picture pixels per
/// viewport pixel: lengths in px are the viewport's, and what is said per mille of the picture's
/// height has become such a length before it comes here.
struct ImageFilter {
  const char* name;
  std::span<const char* const> shaders;
  FilterPlan (*plan)(const Json& parameters, double resolution_scale);
  void (*set_parameters)(const gl::Program& program, const Json& parameters,
                         double resolution_scale);
};

/// What a filter of one shader that looks at a pixel's neighbours at the most has as its plan.
FilterPlan single_step(const Json& parameters, double resolution_scale);

}  // namespace cutaway
