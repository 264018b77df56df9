#include "load/schema_judge.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace cutaway::load {

namespace {

using Json = nlohmann::json;

// valijson writes a place as "<root>", "[name]", "[2]"; a name is taken as it is, brackets inside
// of it too.
Json::json_pointer pointer_of(const std::vector<std::string>& context) {
  Json::json_pointer place;
  for (const std::string& part : context) {
    if (part.size() >= 2 && part.front() == '[') place.push_back(part.substr(1, part.size() - 2));
  }
  return place;
}

}  // namespace

std::vector<Json::json_pointer> faulty_places(const Json& document, const Json& schema) {
  valijson::Schema compiled;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), compiled);
  valijson::ValidationResults results;
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  const valijson::adapters::NlohmannJsonAdapter target(document);
  std::vector<Json::json_pointer> places;
  if (validator.validate(compiled, target, &results)) return places;
  for (const auto& error : results) places.push_back(pointer_of(error.context));
  return places;
}

}  // namespace cutaway::load
