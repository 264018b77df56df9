// protocol/schema/load-script.schema.json, embedded.
#pragma once

#include <string_view>

namespace cutaway::load {

std::string_view script_schema_text();

}  // namespace cutaway::load
