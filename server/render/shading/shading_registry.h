#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "render/shading/shading_model.h"
#include "render/view_buffers.h"
#include "scene/scene.h"

namespace cutaway {

/// Every shading model; its parameters' names, ranges and defaults are in the scene's schema.
std::span<const ShadingModel> shading_models();

/// There has to be one of that name.
const ShadingModel& find_shading_model(std::string_view name);

/// With these a shader's `#include SHADING_FILE` is the model's file, `SHADE` its function and
/// `SHADE_TURNING` the one that is told how normals turn, where it has one.
std::map<std::string, std::string> shader_definitions(const ShadingModel& model);

/// Whether the module's parameters ask how normals turn (see shading_model.h).
bool reads_turning(const Module& module);

/// The text of shading_models.glsl: every model, and `vec3 shade(int branch, vec3 normal, vec3
/// to_viewer)`, which calls the branch's.
std::string shading_models_glsl();

/// Makes `module` the branch's shading in a program that includes shade.glsl.
void set_shading(const gl::Program& program, BranchIndex branch, const Module& module);

}  // namespace cutaway
