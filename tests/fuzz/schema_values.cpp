#include "fuzz/schema_values.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace cutaway::fuzz {

namespace {

const auto& any_of(const Json& entries, Generator& generator) {
  return *std::next(entries.begin(), static_cast<std::ptrdiff_t>(below(generator, entries.size())));
}

bool is_required(const Json& node, const std::string& field) {
  const Json required = node.value("required", Json::array());
  return std::find(required.begin(), required.end(), field) != required.end();
}

Json object_for(const Json& node, Generator& generator) {
  Json object = Json::object();
  const Json properties = node.value("properties", Json::object());
  for (const auto& [name, field] : properties.items()) {
    const bool says_which = field.contains("const");
    if (says_which || is_required(node, name) || below(generator, 3) == 0)
      object[name] = value_for(field, generator);
  }
  return object;
}

Json array_for(const Json& node, Generator& generator) {
  const auto least = node.value("minItems", std::size_t{0});
  const auto most = node.value("maxItems", least + 3);
  Json array = Json::array();
  for (std::size_t left = least + below(generator, most - least + 1); left > 0; --left)
    array.push_back(value_for(node.at("items"), generator));
  return array;
}

Json number_for(const Json& node, Generator& generator) {
  constexpr double kUnlimited = 1e6;
  constexpr int kSteps = 64;
  const double most = node.value("maximum", kUnlimited);
  const double least = node.value("minimum", node.value("exclusiveMinimum", -most));
  if (below(generator, 8) == 0) return node.value("default", Json(0));
  // the ends more often than any place between
  const auto step = std::clamp<int>(int(below(generator, kSteps + 16)) - 8, 0, kSteps);
  const double value = least + ((most - least) * step / kSteps);
  if (node.at("type") == "integer") return static_cast<std::int64_t>(value);
  return value;
}

Json text_for(const Json& node, Generator& generator) {
  static constexpr const char* kTexts[] = {"ball", "x", "phantom:head", "\xF0\x9F\x98\x80", " "};
  if (below(generator, 8) == 0) return std::string(node.value("maxLength", std::size_t{8}), 'a');
  return kTexts[below(generator, std::size(kTexts))];
}

}  // namespace

Json value_for(const Json& node, Generator& generator) {
  if (node.contains("const")) return node.at("const");
  if (node.contains("oneOf")) return value_for(any_of(node.at("oneOf"), generator), generator);
  if (node.contains("enum")) return any_of(node.at("enum"), generator);
  const Json type = node.value("type", Json());
  if (type == "object") return object_for(node, generator);
  if (type == "array") return array_for(node, generator);
  if (type == "string") return text_for(node, generator);
  if (type == "boolean") return below(generator, 2) == 0;
  if (type == "number" || type == "integer") return number_for(node, generator);
  return nullptr;
}

Json field_for(const Json& node, Generator& generator) {
  if (!node.contains("properties")) return value_for(node, generator);
  auto field = node.at("properties").begin();
  std::advance(field, static_cast<std::ptrdiff_t>(below(generator, node.at("properties").size())));
  return {{field.key(), field_for(field.value(), generator)}};
}

}  // namespace cutaway::fuzz
