#include "scene/modules.h"

#include <map>
#include <string>

#include "scene/embedded.h"
#include "scene/lenses/lens_shape.h"
#include "scene/relative_lengths.h"
#include "scene/schema.h"

namespace cutaway {

namespace {

using OrderedJson = nlohmann::ordered_json;

std::string type_of(const Json& parameter) {
  if (parameter.value("x-kind", "") == "colour") return "colour";
  if (parameter.contains("enum")) return "choice";
  return parameter.at("type").get<std::string>();
}

Json describe_parameter(const std::string& name, const Json& parameter) {
  Json description{{"name", name},
                   {"title", parameter.at("title")},
                   {"description", parameter.at("description")},
                   {"type", type_of(parameter)},
                   {"default", parameter.at("default")},
                   {"level", parameter.at("x-level")}};
  for (const auto& [from, to] : {std::pair{"minimum", "minimum"},
                                 {"maximum", "maximum"},
                                 {"x-step", "step"},
                                 {"x-unit", "unit"},
                                 {"x-axis", "axis"},
                                 {"enum", "choices"}})
    if (parameter.contains(from)) description[to] = parameter.at(from);
  return description;
}

/// The same length in per mille of the picture's height, where the module takes it.
Json describe_relative(const std::string& name, const Json& parameter) {
  return {{"name", name},
          {"minimum", parameter.at("minimum")},
          {"maximum", parameter.at("maximum")},
          {"step", parameter.at("x-step")},
          {"unit", parameter.at("x-unit")}};
}

Json describe_parameter_of(const Json& module, const std::string& name) {
  const Json& parameters = module.at("properties");
  Json description = describe_parameter(name, parameters.at(name));
  const std::string relative = per_mille_name(name);
  if (parameters.contains(relative))
    description["relative"] = describe_relative(relative, parameters.at(relative));
  return description;
}

/// `ordered` is the module as it stands in the file: Json sorts its fields, and people want the
/// author's order.
Json describe_module(const Json& module, const OrderedJson& ordered) {
  Json parameters = Json::array();
  for (const auto& [name, field] : ordered.at("properties").items())
    if (name != "name" && !field.contains("x-alias") && !is_per_mille(name))
      parameters.push_back(describe_parameter_of(module, name));
  return {{"name", module.at("properties").at("name").at("const")},
          {"title", module.at("title")},
          {"description", module.at("description")},
          {"parameters", std::move(parameters)}};
}

Json describe_kind(const char* pointer_in_scene, const OrderedJson& ordered) {
  Json modules = Json::array();
  for (const Json& module : schema("scene").at(Json::json_pointer(pointer_in_scene)).at("oneOf")) {
    const auto& name = module.at("properties").at("name").at("const").get_ref<const std::string&>();
    modules.push_back(describe_module(module, ordered.at(name)));
  }
  return modules;
}

Json outline_of(const UnitBody& body) {
  Json profile = Json::array();
  for (const glm::dvec2& corner : body.profile) profile.push_back({corner.x, corner.y});
  return {{"profile", std::move(profile)}, {"round", body.is_round}};
}

Json describe_lens_shapes(const OrderedJson& ordered) {
  Json shapes = describe_kind("/properties/lens/properties/shape", ordered.at("lens_shape"));
  for (Json& shape : shapes) {
    const auto& name = shape.at("name").get_ref<const std::string&>();
    shape["outline"] = outline_of(*find_lens_shape(name).body);
  }
  return shapes;
}

std::vector<LensAxis> axes_of(const Json& shape) {
  std::vector<LensAxis> axes;
  for (const Json& parameter : shape.at("parameters")) {
    if (!parameter.contains("axis")) continue;
    const char letter = parameter.at("axis").get_ref<const std::string&>().front();
    axes.push_back({letter - 'x', parameter.at("name").get<std::string>()});
  }
  return axes;
}

OrderedJson ordered_definitions() {
  for (const EmbeddedFile& file : embedded_schemas())
    if (file.name == "modules.schema.json") return OrderedJson::parse(file.text).at("definitions");
  throw std::out_of_range("modules.schema.json is not embedded");
}

}  // namespace

const Json& describe_modules() {
  static const Json description = [] {
    const OrderedJson ordered = ordered_definitions();
    return Json{
        {"shading", describe_kind("/properties/focus/properties/shading", ordered.at("shading"))},
        {"filter",
         describe_kind("/properties/focus/properties/filters/items", ordered.at("filter"))},
        {"lens_shape", describe_lens_shapes(ordered)}};
  }();
  return description;
}

const std::vector<LensAxis>& lens_axes(std::string_view shape) {
  static const auto axes = [] {
    std::map<std::string, std::vector<LensAxis>, std::less<>> by_shape;
    for (const Json& each : describe_modules().at("lens_shape"))
      by_shape.emplace(each.at("name").get<std::string>(), axes_of(each));
    return by_shape;
  }();
  return axes.find(shape)->second;
}

}  // namespace cutaway
