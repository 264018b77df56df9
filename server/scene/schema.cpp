#include "scene/schema.h"

#include <map>

#include "core/check.h"
#include "core/error.h"
#include "scene/embedded.h"
#include "scene/json_text.h"
#include "scene/relative_lengths.h"
#include "scene/schema_node.h"
#include "scene/schema_violation.h"

namespace cutaway {

namespace {

constexpr std::string_view kFileEnding = ".schema.json";

std::string name_of(std::string_view file) {
  return std::string(file.substr(0, file.rfind(kFileEnding)));
}

using Documents = std::map<std::string, Json, std::less<>>;

Documents read_documents() {
  Documents documents;
  for (const EmbeddedFile& file : embedded_schemas())
    documents.emplace(name_of(file.name), Json::parse(file.text));
  return documents;
}

/// Replaces each $ref by what it names; the annotations next to it (title, description, default)
/// win.
class Inliner {
 public:
  explicit Inliner(const Documents& documents) : documents_(documents) {}

  Json inlined(const Json& node, const std::string& document) const {
    if (node.is_array()) {
      Json result = Json::array();
      for (const Json& entry : node) result.push_back(inlined(entry, document));
      return result;
    }
    return node.is_object() ? inlined_object(node, document) : node;
  }

 private:
  Json inlined_object(const Json& node, const std::string& document) const {
    Json result = node.contains("$ref") ? target(node.at("$ref").get<std::string>(), document)
                                        : Json::object();
    for (const auto& [key, value] : node.items())
      if (key != "$ref" && key != "$id" && key != "$schema" && key != "definitions")
        result[key] = inlined(value, document);
    return result;
  }

  Json target(const std::string& reference, const std::string& document) const {
    const std::size_t hash = std::min(reference.find('#'), reference.size());
    const std::string other = hash == 0 ? document : name_of(reference.substr(0, hash));
    const std::string pointer = hash < reference.size() ? reference.substr(hash + 1) : "";
    return inlined(documents_.at(other).at(Json::json_pointer(pointer)), other);
  }

  const Documents& documents_;
};

/// A keyword that first_violation does not know would be a check that is never made.
void check_keywords(const Json& node) {
  for (const auto& [name, value] : node.items()) {
    check(is_known_keyword(name), "unknown keyword in a schema: " + name);
    if (name == "items") check_keywords(value);
    if (name == "properties" || name == "oneOf")
      for (const Json& child : value) check_keywords(child);
  }
}

Documents inline_all() {
  const Documents documents = read_documents();
  const Inliner inliner(documents);
  Documents result;
  for (const auto& [name, document] : documents) {
    Json inlined = inliner.inlined(document, name);
    check_keywords(inlined);
    result.emplace(name, std::move(inlined));
  }
  return result;
}

void fill(const Json& node, Json& value);

void fill_object(const Json& node, Json& value) {
  if (!node.contains("properties")) return;
  for (const auto& [key, field] : node.at("properties").items()) {
    const auto found = value.find(key);
    if (value.contains(per_mille_name(key))) continue;  // the same length in another unit
    Json content = found != value.end() ? std::move(*found) : field.value("default", Json());
    if (content.is_null() && field.value("type", Json()) == "object") content = Json::object();
    if (content.is_null()) continue;
    fill(field, content);
    value[key] = std::move(content);
  }
}

void fill(const Json& node, Json& value) {
  if (node.contains("oneOf")) {
    if (const Json* branch = chosen_branch(node, value)) fill_object(*branch, value);
  } else if (value.is_object()) {
    fill_object(node, value);
  } else if (value.is_array() && node.contains("items")) {
    for (Json& entry : value) fill(node.at("items"), entry);
  }
}

}  // namespace

const Json& schema(std::string_view name) {
  static const Documents all = inline_all();
  const auto found = all.find(name);
  if (found == all.end()) throw std::out_of_range("no schema " + std::string(name));
  return found->second;
}

void validate(const Json& value, std::string_view schema_name) {
  if (auto violation = first_violation(schema(schema_name), value)) {
    violation->field = shortened(violation->field, 200);
    throw Error(*violation);
  }
}

Json with_defaults(Json value, std::string_view schema_name) {
  fill(schema(schema_name), value);
  return value;
}

NumberRange number_range(std::string_view schema_name, const std::string& pointer) {
  const Json& node = schema(schema_name).at(Json::json_pointer(pointer));
  return {node.at("minimum").get<double>(), node.at("maximum").get<double>()};
}

}  // namespace cutaway
