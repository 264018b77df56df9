#include "unit/scene/schema_judge.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace cutaway {

struct SchemaJudge::Compiled {
  valijson::Schema schema;
};

SchemaJudge::SchemaJudge(const Json& schema) {
  auto compiled = std::make_unique<Compiled>();
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), compiled->schema);
  compiled_ = std::move(compiled);
}

SchemaJudge::~SchemaJudge() = default;
SchemaJudge::SchemaJudge(SchemaJudge&&) noexcept = default;
SchemaJudge& SchemaJudge::operator=(SchemaJudge&&) noexcept = default;

bool SchemaJudge::accepts(const Json& value) const {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  return validator.validate(compiled_->schema, valijson::adapters::NlohmannJsonAdapter(value),
                            nullptr);
}

}  // namespace cutaway
