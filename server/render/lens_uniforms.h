// The lens in shaders: scene/lenses/lens.glsl.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gl/program.h"
#include "scene/lenses/funnel.h"
#include "scene/scene.h"

namespace cutaway {

/// The GLSL files of the unit bodies that the registry's shapes are made of, each once.
std::vector<std::string> lens_body_files();

/// The one of a lens' shape.
std::string lens_body_file(const Lens& lens);

/// With these a shader's `#include "lens.glsl"` is of that body.
std::map<std::string, std::string> lens_definitions(const std::string& body_file);

/// In a program that includes lens.glsl, of the lens' body.
void set_lens_body(const gl::Program& program, const Lens& lens);

/// In a program that includes funnel.glsl.
void set_funnel(const gl::Program& program, const std::optional<Funnel>& funnel);

}  // namespace cutaway
