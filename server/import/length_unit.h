// Units of length as files name them.
#pragma once

#include <optional>
#include <string_view>

namespace cutaway::reading {

/// Of "m", "cm", "mm", "um", "nm", angstrom, "pm" and "in" with their common spellings, in any
/// case; nothing for others.
std::optional<double> millimetres_per(std::string_view unit);

/// Whether it says that lengths are counted in voxels.
bool is_no_length(std::string_view unit);

}  // namespace cutaway::reading
