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
  throw Error({.code = ErrorCode::invalid_scene,
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

/// Wherever the schema has modules.
void replace_in(const Json& node, Json& value, const std::string& pointer) {
  if (node.contains("oneOf")) {
    replace_in_module(node, value, pointer);
  } else if (value.is_array() && node.contains("items")) {
    for (std::size_t i = 0; i < value.size(); ++i)
      replace_in(node.at("items"), value[i], pointer_to(pointer, i));
  } else if (value.is_object()) {
    for (const auto& [key, field] : value.items())
      if (const Json* child = property(node, key))
        replace_in(*child, field, pointer_to(pointer, key));
  }
}

}  // namespace

Json without_aliases(Json document) {
  replace_in(schema("scene"), document, "");
  return document;
}

}  // namespace cutaway
