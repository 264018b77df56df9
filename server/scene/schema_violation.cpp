#include "scene/schema_violation.h"

#include <algorithm>

#include "scene/json_text.h"
#include "scene/schema_node.h"
#include "scene/schema_words.h"

namespace cutaway {

namespace {

using Violation = std::optional<Error::Detail>;

Violation violation(const char* code, std::string message, const std::string& pointer,
                    std::string expected, std::string received) {
  return Error::Detail{.code = code,
                       .message = std::move(message),
                       .field = shortened(pointer, 200),
                       .expected = std::move(expected),
                       .received = std::move(received)};
}

bool is_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

bool has_allowed_type(const Json& schema, const Json& value) {
  const auto types = schema.find("type");
  if (types == schema.end()) return true;
  if (types->is_string()) return is_type(value, types->get_ref<const std::string&>());
  return std::any_of(types->begin(), types->end(), [&](const Json& type) {
    return is_type(value, type.get_ref<const std::string&>());
  });
}

Violation wrong_type(const Json& schema, const Json& value, const std::string& pointer) {
  const Json* constant = schema.contains("const") ? &schema.at("const") : nullptr;
  const bool right =
      has_allowed_type(schema, value) && (constant == nullptr || constant->type() == value.type() ||
                                          (constant->is_number() && value.is_number()));
  if (right) return {};
  return violation("wrong-type", "wrong type", pointer, words_for(schema), words_for_value(value));
}

bool is_out_of_range(const Json& schema, const Json& value) {
  if (schema.contains("const")) return schema.at("const") != value;
  if (schema.contains("enum")) {
    const Json& allowed = schema.at("enum");
    return std::find(allowed.begin(), allowed.end(), value) == allowed.end();
  }
  if (value.is_number())
    return (schema.contains("minimum") && value < schema.at("minimum")) ||
           (schema.contains("exclusiveMinimum") && value <= schema.at("exclusiveMinimum")) ||
           (schema.contains("maximum") && value > schema.at("maximum"));
  if (!value.is_array() && !value.is_string()) return false;
  const std::size_t length = value.is_array() ? value.size() : character_count(value);
  const bool array = value.is_array();
  return length < schema.value(array ? "minItems" : "minLength", std::size_t{0}) ||
         length > schema.value(array ? "maxItems" : "maxLength", std::size_t(-1));
}

Violation out_of_range(const Json& schema, const Json& value, const std::string& pointer) {
  if (!is_out_of_range(schema, value)) return {};
  const bool list = value.is_array();
  return violation("out-of-range", list ? "wrong number of entries" : "not an allowed value",
                   pointer, words_for(schema),
                   list ? std::to_string(value.size()) + " entries" : words_for_value(value));
}

Violation wrong_branch(const Json& schema, const Json& value, const std::string& pointer) {
  const std::string key = discriminator(schema);
  const std::string field = pointer_to(pointer, key);
  if (!value.is_object())
    return violation("wrong-type", "wrong type", pointer, "an object", words_for_value(value));
  if (!value.contains(key))
    return violation("missing-field", "missing field", field, words_for_branches(schema), "");
  if (!value.at(key).is_string())
    return violation("wrong-type", "wrong type", field, words_for_branches(schema),
                     words_for_value(value.at(key)));
  if (const Json* branch = chosen_branch(schema, value))
    return first_violation(*branch, value, pointer);
  return key == "type" ? violation("unknown-message", "unknown message", field,
                                   words_for_branches(schema), words_for_value(value.at(key)))
                       : violation("unknown-module", "unknown module", field,
                                   words_for_branches(schema), words_for_value(value.at(key)));
}

Violation unknown_field(const Json& schema, const Json& value, const std::string& pointer) {
  if (schema.value("additionalProperties", true)) return {};
  for (const auto& [key, ignored] : value.items())
    if (property(schema, key) == nullptr)
      return violation("unknown-field", "unknown field", pointer_to(pointer, key),
                       words_for_fields(schema), "");
  return {};
}

Violation missing_field(const Json& schema, const Json& value, const std::string& pointer) {
  if (!schema.contains("required")) return {};
  for (const Json& key : schema.at("required")) {
    const auto& name = key.get_ref<const std::string&>();
    const Json* field = property(schema, name);
    if (!value.contains(name))
      return violation("missing-field", "missing field", pointer_to(pointer, name),
                       field != nullptr ? words_for(*field) : "", "");
  }
  return {};
}

Violation wrong_fields(const Json& schema, const Json& value, const std::string& pointer) {
  if (auto found = unknown_field(schema, value, pointer)) return found;
  if (auto found = missing_field(schema, value, pointer)) return found;
  for (const auto& [key, field] : value.items())
    if (const Json* node = property(schema, key))
      if (auto found = first_violation(*node, field, pointer_to(pointer, key))) return found;
  return {};
}

Violation wrong_entries(const Json& schema, const Json& value, const std::string& pointer) {
  const auto entry = schema.find("items");
  if (entry == schema.end()) return {};
  for (std::size_t i = 0; i < value.size(); ++i)
    if (auto found = first_violation(*entry, value[i], pointer_to(pointer, i))) return found;
  return {};
}

}  // namespace

Violation first_violation(const Json& schema, const Json& value, const std::string& pointer) {
  if (schema.contains("oneOf")) return wrong_branch(schema, value, pointer);
  if (auto found = wrong_type(schema, value, pointer)) return found;
  if (auto found = out_of_range(schema, value, pointer)) return found;
  if (value.is_object()) return wrong_fields(schema, value, pointer);
  if (value.is_array()) return wrong_entries(schema, value, pointer);
  return {};
}

}  // namespace cutaway
