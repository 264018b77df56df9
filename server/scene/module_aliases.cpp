#include "scene/module_aliases.h"

#include <cmath>

#include "core/error.h"
#include "scene/json_text.h"
#include "scene/schema.h"
#include "scene/schema_node.h"
#include "scene/schema_violation.h"

namespace cutaway {

namespace {

/// The schema of `key` where it is an alias in one of the modules that may stand at a place; a
/// patch need not say again which module it means.
const Json* alias_schema(const Json& modules, const std::string& key) {
  for (const Json& module : modules.at("oneOf")) {
    const Json* field = property(module, key);
    if (field != nullptr && field->contains("x-alias")) return field;
  }
  return nullptr;
}

void check_alias(const Json& schema, const Json& module, const std::string& key,
                 const std::string& pointer) {
  const std::string field = pointer_to(pointer, key);
  if (auto violation = first_violation(schema, module.at(key))) {
    violation->field = field;
    throw Error(*violation);
  }
  const auto& real = schema.at("x-alias").at("of").get_ref<const std::string&>();
  if (!module.contains(real) || module.at(real).is_null()) return;
  throw Error({.code = "invalid-scene",
               .message = key + " is another name of " + real + ", and both are there",
               .field = field,
               .expected = "one of the two",
               .received = json_text(module.at(key))});
}

/// Whole numbers stay whole: a window of 4 or 5 pixels has the radius 2.
Json real_value(const Json& alias, const Json& value) {
  const double scaled = value.get<double>() * alias.at("factor").get<double>();
  return value.is_number_integer() && alias.value("whole", false)
             ? Json(static_cast<std::int64_t>(std::floor(scaled)))
             : Json(scaled);
}

void replace_in_module(const Json& modules, Json& module, const std::string& pointer) {
  if (!module.is_object()) return;
  const Json said = module;
  for (const auto& [key, value] : said.items()) {
    const Json* schema = value.is_null() ? nullptr : alias_schema(modules, key);
    if (schema == nullptr) continue;
    check_alias(*schema, said, key, pointer);
    const Json& alias = schema->at("x-alias");
    module[alias.at("of").get_ref<const std::string&>()] = real_value(alias, value);
    module.erase(key);
  }
}

void replace_in_branch(Json& branch, const std::string& pointer) {
  if (!branch.is_object()) return;
  const Json& properties = schema("scene").at("properties").at("focus").at("properties");
  if (branch.contains("shading"))
    replace_in_module(properties.at("shading"), branch.at("shading"), pointer + "/shading");
  if (!branch.contains("filters") || !branch.at("filters").is_array()) return;
  Json& filters = branch.at("filters");
  for (std::size_t i = 0; i < filters.size(); ++i)
    replace_in_module(properties.at("filters").at("items"), filters[i],
                      pointer_to(pointer + "/filters", i));
}

}  // namespace

Json without_aliases(Json document) {
  if (!document.is_object()) return document;
  for (const char* branch : {"focus", "context"})
    if (document.contains(branch)) replace_in_branch(document.at(branch), pointer_to("", branch));
  return document;
}

}  // namespace cutaway
