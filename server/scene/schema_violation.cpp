#include "scene/schema_violation.h"

#include <algorithm>
#include <set>

#include "scene/json_text.h"
#include "scene/schema_node.h"
#include "scene/schema_words.h"

namespace cutaway {

namespace {

using Violation = std::optional<Error::Detail>;

Violation violation(ErrorCode code, const char* message, std::string field, std::string expected,
                    std::string received) {
  return Error::Detail{.code = code,
                       .message = message,
                       .field = std::move(field),
                       .expected = std::move(expected),
                       .received = std::move(received)};
}

/// Pointers are put together on the way out, so that a document without a violation costs none.
template <typename Token>
Violation inside(const Token& token, Violation found) {
  if (found) found->field = pointer_to("", token) + found->field;
  return found;
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
  const Json* types = keyword(schema, "type");
  if (types == nullptr) return true;
  if (types->is_string()) return is_type(value, types->get_ref<const std::string&>());
  return std::any_of(types->begin(), types->end(), [&](const Json& type) {
    return is_type(value, type.get_ref<const std::string&>());
  });
}

bool is_like_constant(const Json& schema, const Json& value) {
  const Json* constant = keyword(schema, "const");
  return constant == nullptr || constant->type() == value.type() ||
         (constant->is_number() && value.is_number());
}

Violation wrong_type(const Json& schema, const Json& value) {
  if (has_allowed_type(schema, value) && is_like_constant(schema, value)) return {};
  return violation(ErrorCode::wrong_type, "wrong type", "", words_for(schema),
                   words_for_value(value));
}

bool is_outside(const Json& schema, const Json& number) {
  const Json* minimum = keyword(schema, "minimum");
  const Json* above = keyword(schema, "exclusiveMinimum");
  const Json* maximum = keyword(schema, "maximum");
  return (minimum != nullptr && number < *minimum) || (above != nullptr && number <= *above) ||
         (maximum != nullptr && number > *maximum);
}

bool is_wrong_length(const Json& schema, const Json& value) {
  const bool list = value.is_array();
  const Json* minimum = keyword(schema, list ? "minItems" : "minLength");
  const Json* maximum = keyword(schema, list ? "maxItems" : "maxLength");
  if (minimum == nullptr && maximum == nullptr) return false;
  const std::size_t length = list ? value.size() : character_count(value);
  return (minimum != nullptr && length < minimum->get<std::size_t>()) ||
         (maximum != nullptr && length > maximum->get<std::size_t>());
}

bool is_out_of_range(const Json& schema, const Json& value) {
  if (const Json* constant = keyword(schema, "const")) return *constant != value;
  if (const Json* allowed = keyword(schema, "enum"))
    return std::find(allowed->begin(), allowed->end(), value) == allowed->end();
  if (value.is_number()) return is_outside(schema, value);
  return (value.is_array() || value.is_string()) && is_wrong_length(schema, value);
}

Violation out_of_range(const Json& schema, const Json& value) {
  if (!is_out_of_range(schema, value)) return {};
  if (value.is_array())
    return violation(ErrorCode::out_of_range, "wrong number of entries", "", words_for(schema),
                     std::to_string(value.size()) + " entries");
  return violation(ErrorCode::out_of_range, "not an allowed value", "", words_for(schema),
                   words_for_value(value));
}

Violation no_branch(const Json& schema, const Json& value, const std::string& key) {
  const std::string field = pointer_to("", key);
  const std::string names = words_for_branches(schema);
  if (!value.contains(key))
    return violation(ErrorCode::missing_field, "missing field", field, names, "");
  const std::string received = words_for_value(value.at(key));
  if (!value.at(key).is_string())
    return violation(ErrorCode::wrong_type, "wrong type", field, names, received);
  if (key == "type")
    return violation(ErrorCode::unknown_message, "unknown message", field, names, received);
  return violation(ErrorCode::unknown_module, "unknown module", field, names, received);
}

Violation wrong_branch(const Json& schema, const Json& value) {
  if (!value.is_object())
    return violation(ErrorCode::wrong_type, "wrong type", "", "an object", words_for_value(value));
  if (const Json* branch = chosen_branch(schema, value)) return first_violation(*branch, value);
  return no_branch(schema, value, discriminator(schema));
}

Violation unknown_field(const Json& schema, const Json& value) {
  if (schema.value("additionalProperties", true)) return {};
  for (const auto& [key, ignored] : value.items())
    if (property(schema, key) == nullptr)
      return violation(ErrorCode::unknown_field, "unknown field", pointer_to("", key),
                       words_for_fields(schema), "");
  return {};
}

Violation missing_field(const Json& schema, const Json& value) {
  const Json* required = keyword(schema, "required");
  if (required == nullptr) return {};
  for (const Json& key : *required) {
    const auto& name = key.get_ref<const std::string&>();
    if (!value.contains(name))
      return violation(ErrorCode::missing_field, "missing field", pointer_to("", name),
                       words_for(schema.at("properties").at(name)), "");
  }
  return {};
}

Violation wrong_fields(const Json& schema, const Json& value) {
  if (auto found = unknown_field(schema, value)) return found;
  if (auto found = missing_field(schema, value)) return found;
  for (const auto& [key, field] : value.items())
    if (const Json* node = property(schema, key))
      if (auto found = inside(key, first_violation(*node, field))) return found;
  return {};
}

Violation wrong_entries(const Json& schema, const Json& value) {
  const Json* entry = keyword(schema, "items");
  if (entry == nullptr) return {};
  for (std::size_t i = 0; i < value.size(); ++i)
    if (auto found = inside(i, first_violation(*entry, value[i]))) return found;
  return {};
}

}  // namespace

Violation first_violation(const Json& schema, const Json& value) {
  if (schema.contains("oneOf")) return wrong_branch(schema, value);
  if (auto found = wrong_type(schema, value)) return found;
  if (auto found = out_of_range(schema, value)) return found;
  if (value.is_object()) return wrong_fields(schema, value);
  if (value.is_array()) return wrong_entries(schema, value);
  return {};
}

bool is_known_keyword(const std::string& keyword) {
  static const std::set<std::string> known{"additionalProperties",
                                           "const",
                                           "default",
                                           "description",
                                           "enum",
                                           "exclusiveMinimum",
                                           "items",
                                           "maxItems",
                                           "maxLength",
                                           "maximum",
                                           "minItems",
                                           "minLength",
                                           "minimum",
                                           "oneOf",
                                           "properties",
                                           "required",
                                           "title",
                                           "type"};
  return known.contains(keyword) || keyword.starts_with("x-");
}

}  // namespace cutaway
