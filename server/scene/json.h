#pragma once

#include <nlohmann/json.hpp>

namespace cutaway {
using Json = nlohmann::json;
}
