#include "scene/admitted.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/schema.h"

namespace cutaway {

namespace {

void admit_number(const Json& node, Json& number) {
  const double value = number.get<double>();
  const double least = node.value("minimum", std::numeric_limits<double>::lowest());
  const double most = node.value("maximum", std::numeric_limits<double>::max());
  if (value >= least && value <= most) return;
  number = std::isnan(value) ? least : std::clamp(value, least, most);
}

/// Modules (oneOf) are chosen by people alone, and are as they were checked.
void admit(const Json& node, Json& value) {
  if (value.is_number()) {
    admit_number(node, value);
  } else if (value.is_array() && node.contains("items")) {
    for (Json& entry : value) admit(node.at("items"), entry);
  } else if (value.is_object() && node.contains("properties")) {
    const Json& properties = node.at("properties");
    for (const auto& [key, field] : value.items()) {
      if (properties.contains(key)) admit(properties.at(key), field);
    }
  }
}

}  // namespace

Json admitted(Json document, std::string_view schema_name) {
  admit(schema(schema_name), document);
  return document;
}

}  // namespace cutaway
