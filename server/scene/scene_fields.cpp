#include "scene/scene_fields.h"

#include <algorithm>

#include "core/check.h"
#include "scene/schema.h"
#include "scene/schema_node.h"

namespace cutaway {

NLOHMANN_JSON_SERIALIZE_ENUM(BelongsTo, {{BelongsTo::look, "look"},
                                         {BelongsTo::volume, "volume"},
                                         {BelongsTo::view, "view"},
                                         {BelongsTo::document, "document"}})
NLOHMANN_JSON_SERIALIZE_ENUM(OnlyReader,
                             {{OnlyReader::composite, "composite"}, {OnlyReader::slices, "slices"}})

namespace {

void collect(const Json& node, const Json::json_pointer& pointer, std::vector<SceneField>& fields) {
  if (const Json* belongs_to = keyword(node, "x-belongs-to")) {
    fields.push_back({pointer, belongs_to->get<BelongsTo>()});
    return;
  }
  const Json* properties = keyword(node, "properties");
  check(properties != nullptr, "the schema does not say what belongs to " + pointer.to_string());
  for (const auto& [name, property] : properties->items())
    collect(property, pointer / name, fields);
}

/// A part of which nothing is left goes with the field.
void erase(Json& document, const Json::json_pointer& field) {
  const Json::json_pointer parent = field.parent_pointer();
  Json& part = document.at(parent);
  part.erase(field.back());
  if (part.empty() && !parent.empty()) erase(document, parent);
}

bool is_read_only_by(OnlyReader reader, const Json& node, const Json& patch) {
  if (const Json* only = keyword(node, "x-read-by")) return only->get<OnlyReader>() == reader;
  if (!node.contains("properties") || !patch.is_object()) return false;
  return std::ranges::all_of(patch.items(), [&](const auto& field) {
    const Json* child = property(node, field.key());
    return child != nullptr && is_read_only_by(reader, *child, field.value());
  });
}

}  // namespace

const std::vector<SceneField>& scene_fields() {
  static const std::vector<SceneField> all = [] {
    std::vector<SceneField> fields;
    collect(schema("scene"), Json::json_pointer(), fields);
    return fields;
  }();
  return all;
}

Json only_fields(const Json& document, BelongsTo belongs_to) {
  Json result = Json::object();
  for (const SceneField& field : scene_fields())
    if (field.belongs_to == belongs_to && document.contains(field.pointer))
      result[field.pointer] = document.at(field.pointer);
  return result;
}

Json without_fields(Json document, BelongsTo belongs_to) {
  for (const SceneField& field : scene_fields())
    if (field.belongs_to == belongs_to && document.contains(field.pointer))
      erase(document, field.pointer);
  return document;
}

bool is_read_only_by(OnlyReader reader, const Json& patch) {
  return is_read_only_by(reader, schema("scene"), patch);
}

}  // namespace cutaway
