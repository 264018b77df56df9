#include "load/script_check.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "load/schema_judge.h"
#include "load/schema_text.h"
#include "load/script_error.h"

namespace cutaway::load {

namespace {

using Json = nlohmann::json;
using Detail = ScriptError::Detail;

constexpr std::size_t kReceivedCharacters = 60;

const Json& schema() {
  static const Json parsed = Json::parse(script_schema_text());
  return parsed;
}

const Json& followed(const Json& rule) {
  if (!rule.contains("$ref")) return rule;
  return schema().at(Json::json_pointer(rule.at("$ref").get<std::string>().substr(1)));
}

// The rule for a place of the document; nothing where the schema leaves the place open.
const Json* rule_at(Json::json_pointer place) {
  if (place.empty()) return &schema();
  const std::string key = place.back();
  place.pop_back();
  const Json* parent = rule_at(place);
  if (!parent) return nullptr;
  if (parent->contains("items")) return &followed(parent->at("items"));
  if (!parent->contains("properties") || !parent->at("properties").contains(key)) return nullptr;
  return &followed(parent->at("properties").at(key));
}

std::string number(const Json& value) {
  std::ostringstream text;
  text << value.get<double>();
  return text.str();
}

std::string list_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string range(const Json& rule, const char* least, const char* most) {
  const bool from = rule.contains(least);
  const bool to = rule.contains(most);
  if (from && to && rule.at(least) == rule.at(most)) return number(rule.at(least));
  if (from && to) return number(rule.at(least)) + " to " + number(rule.at(most));
  if (from) return "at least " + number(rule.at(least));
  return to ? "at most " + number(rule.at(most)) : "any number of";
}

std::vector<std::string> property_names(const Json& rule) {
  std::vector<std::string> names;
  if (!rule.contains("properties")) return names;
  for (const auto& property : rule.at("properties").items()) names.push_back(property.key());
  return names;
}

std::string expected_number(const Json& rule, const std::string& kind) {
  const std::string unit =
      rule.contains("x-unit") ? " " + rule.at("x-unit").get<std::string>() : "";
  const bool bounded = rule.contains("minimum") || rule.contains("maximum");
  return kind + (bounded ? ", " + range(rule, "minimum", "maximum") : "") + unit;
}

std::string expected(const Json& rule) {
  if (rule.contains("const")) return rule.at("const").dump();
  if (rule.contains("enum")) return "one of " + list_of(rule.at("enum"));
  const std::string type = rule.value("type", "");
  if (type == "number") return expected_number(rule, "a number");
  if (type == "integer") return expected_number(rule, "a whole number");
  if (type == "string") return "text of " + range(rule, "minLength", "maxLength") + " characters";
  if (type == "array") return "a list of " + range(rule, "minItems", "maxItems") + " entries";
  if (type == "boolean") return "true or false";
  const std::string names = list_of(property_names(rule));
  if (rule.contains("maxProperties")) return "exactly one of " + names;
  return names.empty() ? "an empty object" : "an object with " + names;
}

std::string received(const Json& value) {
  std::string text = value.dump();
  if (text.size() <= kReceivedCharacters) return text;
  return text.substr(0, kReceivedCharacters) + "...";
}

bool fits_type(const Json& value, const std::string& type) {
  if (type == "number") return value.is_number();
  if (type == "integer") return value.is_number_integer();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "array") return value.is_array();
  return type.empty() || value.is_object();
}

bool outside(double value, const Json& rule, const char* least, const char* most) {
  return (rule.contains(least) && value < rule.at(least).get<double>()) ||
         (rule.contains(most) && value > rule.at(most).get<double>());
}

bool out_of_range(const Json& value, const Json& rule) {
  if (rule.contains("const")) return value != rule.at("const");
  if (rule.contains("enum")) {
    return std::ranges::find(rule.at("enum"), value) == rule.at("enum").end();
  }
  if (value.is_number()) return outside(value.get<double>(), rule, "minimum", "maximum");
  const double size = static_cast<double>(
      value.is_string() ? value.get_ref<const std::string&>().size() : value.size());
  if (value.is_string()) return outside(size, rule, "minLength", "maxLength");
  if (value.is_array()) return outside(size, rule, "minItems", "maxItems");
  return value.is_object() && outside(size, rule, "minProperties", "maxProperties");
}

std::optional<Detail> missing_field(const Json::json_pointer& place, const Json& value,
                                    const Json& rule) {
  if (!rule.contains("required")) return std::nullopt;
  for (const Json& name : rule.at("required")) {
    const auto& key = name.get_ref<const std::string&>();
    if (value.contains(key)) continue;
    const Json* missing = rule_at(place / key);
    return Detail{"missing-field", (place / key).to_string(), expected(*missing), "nothing"};
  }
  return std::nullopt;
}

std::optional<Detail> unknown_field(const Json::json_pointer& place, const Json& value,
                                    const Json& rule) {
  if (rule.value("additionalProperties", true)) return std::nullopt;
  const std::vector<std::string> known = property_names(rule);
  for (const auto& field : value.items()) {
    if (std::ranges::find(known, field.key()) != known.end()) continue;
    return Detail{"unknown-field", (place / field.key()).to_string(), expected(rule),
                  received(field.key())};
  }
  return std::nullopt;
}

// What is wrong at this very place, and not only inside of it.
std::optional<Detail> problem(const Json& document, const Json::json_pointer& place) {
  const Json* rule = rule_at(place);
  if (!rule || !document.contains(place)) return std::nullopt;
  const Json& value = document.at(place);
  if (!fits_type(value, rule->value("type", ""))) {
    return Detail{"wrong-type", place.to_string(), expected(*rule), received(value)};
  }
  if (value.is_object()) {
    if (auto found = missing_field(place, value, *rule)) return found;
    if (auto found = unknown_field(place, value, *rule)) return found;
  }
  if (!out_of_range(value, *rule)) return std::nullopt;
  return Detail{"out-of-range", place.to_string(), expected(*rule), received(value)};
}

}  // namespace

// valijson judges, the schema itself explains: it knows the units and the other fields.
void check_script(const Json& document) {
  const auto places = faulty_places(document, schema());
  for (const auto& place : places) {
    if (auto found = problem(document, place)) throw ScriptError(*found);
  }
  if (places.empty()) return;
  throw ScriptError(
      {"out-of-range", places.front().to_string(), "what the schema describes", "something else"});
}

}  // namespace cutaway::load
