#include "scene/schema_node.h"

#include "core/check.h"

namespace cutaway {

std::string discriminator(const Json& schema) {
  for (const auto& [key, field] : schema.at("oneOf").front().at("properties").items())
    if (field.contains("const") && (key == "name" || key == "type")) return key;
  check(false, "a schema's oneOf has no name or type to tell its branches apart");
  return {};
}

const Json* chosen_branch(const Json& schema, const Json& value) {
  const std::string key = discriminator(schema);
  if (!value.is_object() || !value.contains(key)) return nullptr;
  for (const Json& branch : schema.at("oneOf"))
    if (branch.at("properties").at(key).at("const") == value.at(key)) return &branch;
  return nullptr;
}

const Json* keyword(const Json& schema, const char* name) {
  const auto found = schema.find(name);
  return found == schema.end() ? nullptr : &*found;
}

const Json* property(const Json& schema, const std::string& key) {
  const Json* properties = keyword(schema, "properties");
  if (properties == nullptr) return nullptr;
  const auto field = properties->find(key);
  return field == properties->end() ? nullptr : &*field;
}

}  // namespace cutaway
