#include "scene/scene_json.h"

#include <cmath>
#include <type_traits>

#include "scene/resolve.h"
#include "scene/scene_visit.h"
#include "scene/schema.h"

namespace cutaway {

namespace {

Module module_from(const Json& object) {
  Module module{object.at("name").get<std::string>(), object};
  module.parameters.erase("name");
  return module;
}

void read(const Json& said, std::string& text) { text = said.get<std::string>(); }
void read(const Json& said, glm::dvec3& vector) { vector = vector_from(said); }
void read(const Json& said, std::optional<double>& number) { number = said.get<double>(); }
void read(const Json& said, Module& module) { module = module_from(said); }
void read(const Json& said, std::vector<Module>& modules) {
  modules.clear();
  for (const Json& module : said) modules.push_back(module_from(module));
}

/// A number, a choice, or a struct that scene_visit.h knows.
template <typename T>
void read(const Json& said, T& value) {
  if constexpr (!std::is_class_v<T>)
    value = said.get<T>();
  else
    visit_fields(value, [&said](const char* name, auto& field) {
      if (const auto found = said.find(name); found != said.end()) read(*found, field);
    });
}

bool is_there(const std::optional<double>& number) { return number.has_value(); }
bool is_there(double number) { return std::isfinite(number); }
template <typename T>
bool is_there(const T& /*value*/) {
  return true;
}

Json written(const std::string& text) { return text; }
Json written(const glm::dvec3& vector) { return vector_json(vector); }
Json written(const std::optional<double>& number) { return *number; }
Json written(const Module& module) { return module_json(module); }
Json written(const std::vector<Module>& modules) {
  Json list = Json::array();
  for (const Module& module : modules) list.push_back(module_json(module));
  return list;
}

template <typename T>
Json written(const T& value) {
  if constexpr (!std::is_class_v<T>) {
    return value;
  } else {
    Json object = Json::object();
    visit_fields(value, [&object](const char* name, const auto& field) {
      if (is_there(field)) object[name] = written(field);
    });
    return object;
  }
}

}  // namespace

Scene scene_from(const Json& document) {
  Scene scene;
  read(document, scene);
  return scene;
}

Viewport viewport_from(const Json& said) {
  Viewport viewport;
  read(said, viewport);
  return viewport;
}

Json module_json(const Module& module) {
  Json object = module.parameters;
  object["name"] = module.name;
  return object;
}

Json scene_document(const Scene& scene) {
  Json document = written(scene);
  document["version"] = schema("scene").at("properties").at("version").at("const");
  return document;
}

}  // namespace cutaway
