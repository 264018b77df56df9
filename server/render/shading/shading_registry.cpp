#include "render/shading/shading_registry.h"

#include <algorithm>

#include "core/check.h"

namespace cutaway {

extern const ShadingModel kToneShading;
extern const ShadingModel kGoochShading;
extern const ShadingModel kPhongShading;
extern const ShadingModel kRampShading;

std::span<const ShadingModel> shading_models() {
  static const ShadingModel models[] = {kToneShading, kGoochShading, kPhongShading, kRampShading};
  return models;
}

const ShadingModel& find_shading_model(std::string_view name) {
  const auto models = shading_models();
  const auto model = std::ranges::find(models, name, &ShadingModel::name);
  check(model != models.end(), "no shading model " + std::string(name));
  return *model;
}

std::map<std::string, std::string> shader_definitions(const ShadingModel& model) {
  return {{"SHADING_FILE", '"' + std::string(model.shader) + '"'},
          {"SHADE", std::string("shade_") + model.name},
          {"SHADE_TURNING", std::string("shade_") + model.name + "_turning"}};
}

bool reads_turning(const Module& module) {
  const ShadingModel& model = find_shading_model(module.name);
  return model.reads_turning != nullptr && model.reads_turning(module.parameters);
}

std::string shading_models_glsl() {
  std::string text = "// Made from the registry of shading models.\n";
  std::string cases;
  int number = 0;
  for (const ShadingModel& model : shading_models()) {
    text += "#include \"" + std::string(model.shader) + "\"\n";
    cases += "    case " + std::to_string(number++) + ": return shade_" + model.name +
             "(branch, normal, to_viewer, 1.0);\n";
  }
  return text + "uniform int shading_model[2];  // by branch\n" +
         "vec3 shade(int branch, vec3 normal, vec3 to_viewer) {\n" +
         "  switch (shading_model[branch]) {\n" + cases + "  }\n  return vec3(0.0);\n}\n";
}

void set_shading(const gl::Program& program, BranchIndex branch, const Module& module) {
  const ShadingModel& model = find_shading_model(module.name);
  const std::string index = "[" + std::to_string(branch) + "]";
  const auto number = static_cast<int>(&model - shading_models().data());
  program.set(("shading_model" + index).c_str(), number);
  model.set_parameters(UniformStruct(program, model.name, branch), module.parameters);
}

}  // namespace cutaway
