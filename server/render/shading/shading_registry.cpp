#include "render/shading/shading_registry.h"

#include <algorithm>

#include "core/check.h"

namespace cutaway {

extern const ShadingModel kToneShading;
extern const ShadingModel kGoochShading;
extern const ShadingModel kPhongShading;

std::span<const ShadingModel> shading_models() {
  static const ShadingModel models[] = {kToneShading, kGoochShading, kPhongShading};
  return models;
}

std::string shading_models_glsl() {
  std::string text = "// Made from the registry of shading models.\n";
  std::string cases;
  int number = 0;
  for (const ShadingModel& model : shading_models()) {
    text += "#include \"" + std::string(model.shader) + "\"\n";
    cases += "    case " + std::to_string(number++) + ": return shade_" + model.name +
             "(branch, normal, to_viewer);\n";
  }
  return text + "uniform int shading_model[2];  // by branch\n" +
         "vec3 shade(int branch, vec3 normal, vec3 to_viewer) {\n" +
         "  switch (shading_model[branch]) {\n" + cases + "  }\n  return vec3(0.0);\n}\n";
}

void set_shading(const gl::Program& program, BranchIndex branch, const Module& module) {
  const auto models = shading_models();
  const auto model = std::ranges::find_if(
      models, [&](const ShadingModel& each) { return each.name == module.name; });
  check(model != models.end(), "no shading model " + module.name);
  const std::string index = "[" + std::to_string(branch) + "]";
  program.set(("shading_model" + index).c_str(), static_cast<int>(model - models.begin()));
  model->set_parameters(UniformStruct(program, model->name, branch), module.parameters);
}

}  // namespace cutaway
