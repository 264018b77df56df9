#include "render/shaders.h"

#include "render/shading/shading_registry.h"

namespace cutaway {

gl::ShaderLibrary shader_library() {
  gl::ShaderLibrary library(embedded_shaders());
  library.add("shading_models.glsl", shading_models_glsl());
  return library;
}

}  // namespace cutaway
