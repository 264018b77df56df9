#include "scene/schema_words.h"

#include <algorithm>

#include "scene/json_text.h"
#include "scene/schema_node.h"

namespace cutaway {

namespace {

std::string plain(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

template <typename Range>
std::string list(const Range& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + plain(name);
  return text;
}

std::string limits(const Json& schema, const char* minimum, const char* maximum) {
  const bool low = schema.contains(minimum);
  const bool high = schema.contains(maximum);
  if (low && high && schema.at(minimum) == schema.at(maximum)) return plain(schema.at(minimum));
  if (low && high) return plain(schema.at(minimum)) + " to " + plain(schema.at(maximum));
  if (low) return "at least " + plain(schema.at(minimum));
  return high ? "at most " + plain(schema.at(maximum)) : "";
}

std::string number_words(const Json& schema, const std::string& kind) {
  std::string text = kind;
  if (schema.contains("exclusiveMinimum")) text += " above " + plain(schema.at("exclusiveMinimum"));
  if (const std::string range = limits(schema, "minimum", "maximum"); !range.empty())
    text += (schema.contains("minimum") && schema.contains("maximum") ? " from " : " of ") + range;
  return schema.contains("x-unit") ? text + " " + plain(schema.at("x-unit")) : text;
}

std::string array_words(const Json& schema) {
  const std::string count = limits(schema, "minItems", "maxItems");
  const std::string text = count.empty() ? "a list" : "a list of " + count + " entries";
  return schema.contains("items") ? text + ", each " + words_for(schema.at("items")) : text;
}

std::string string_words(const Json& schema) {
  const std::string count = limits(schema, "minLength", "maxLength");
  return count.empty() ? "a string" : "a string of " + count + " characters";
}

}  // namespace

std::string words_for(const Json& schema) {
  if (schema.contains("oneOf")) return "an object, " + words_for_branches(schema);
  if (schema.contains("const")) return plain(schema.at("const"));
  if (schema.contains("enum")) return "one of " + list(schema.at("enum"));
  const Json type = schema.value("type", Json());
  if (type.is_array()) return "one of " + list(type);
  if (type == "number") return number_words(schema, "a number");
  if (type == "integer") return number_words(schema, "an integer");
  if (type == "array") return array_words(schema);
  if (type == "string") return string_words(schema);
  return type == "boolean" ? "true or false" : "an object";
}

std::string words_for_branches(const Json& schema) {
  const std::string key = discriminator(schema);
  Json names = Json::array();
  for (const Json& branch : schema.at("oneOf"))
    names.push_back(branch.at("properties").at(key).at("const"));
  return key + " one of " + list(names);
}

std::string words_for_fields(const Json& schema) {
  std::string text;
  for (const auto& [key, ignored] : schema.at("properties").items())
    text += (text.empty() ? "one of " : ", ") + key;
  return text;
}

std::string words_for_value(const Json& value) { return shortened(json_text(value)); }

std::size_t character_count(const Json& text) {
  const auto& bytes = text.get_ref<const std::string&>();
  return static_cast<std::size_t>(std::count_if(bytes.begin(), bytes.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

}  // namespace cutaway
