// The distances between the slices of a stack: even, changing, or with holes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cutaway::reading {

struct SliceSpacing {
  double step_mm = 1.0;
  bool is_even = true;
  std::string warning = {};  ///< where they are not
};

/// Of slices at `heights_mm`, two or more, rising from 0, of which each is off by as much as
/// `tolerance_mm` at most. Uneven ones get the step to resample to: the finest distance that holds
/// for a stretch of the stack, else the usual one. Throws Error naming `file` where slices coincide
/// or run back, or too many are missing in one place.
SliceSpacing spacing_of(const std::filesystem::path& file, const std::vector<double>& heights_mm,
                        double tolerance_mm);

}  // namespace cutaway::reading
