// Which places of a document do not follow a schema, by valijson.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cutaway::load {

/// JSON pointers into the document, in the order in which valijson complains; the places that
/// contain a faulty one are among them. Empty where the document follows the schema (draft-07).
/// In a translation unit of its own because valijson takes long to compile.
std::vector<nlohmann::json::json_pointer> faulty_places(const nlohmann::json& document,
                                                        const nlohmann::json& schema);

}  // namespace cutaway::load
