// Holds a script against protocol/schema/load-script.schema.json.
#pragma once

#include <nlohmann/json.hpp>

namespace cutaway::load {

/// Throws ScriptError that names the first faulty field, what was expected there and what came.
void check_script(const nlohmann::json& document);

}  // namespace cutaway::load
