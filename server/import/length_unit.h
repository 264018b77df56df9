// Units of length as files name them.
#pragma once

#include <optional>
#include <string_view>

namespace cutaway::reading {

/// Of "mm", "cm", "m", "um" and "in" with their common spellings, in any case; nothing for others.
std::optional<double> millimetres_per(std::string_view unit);

}  // namespace cutaway::reading
