// Whether a document follows a schema, by valijson: the reference for our own checker.
#pragma once

#include <memory>

#include "scene/json.h"

namespace cutaway {

/// Immutable once made; thread-safe. In a translation unit of its own because valijson takes long
/// to compile.
class SchemaJudge {
 public:
  /// `schema` is draft-07 without $refs.
  explicit SchemaJudge(const Json& schema);
  ~SchemaJudge();
  SchemaJudge(SchemaJudge&&) noexcept;
  SchemaJudge& operator=(SchemaJudge&&) noexcept;

  bool accepts(const Json& value) const;

 private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

}  // namespace cutaway
