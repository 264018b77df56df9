// "slice2" before "slice10", and which names make up a stack.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cutaway::reading {

/// Runs of digits compare as numbers of any length, all else by bytes; equal numbers with fewer
/// leading zeros first.
struct NaturalOrder {
  bool operator()(std::string_view a, std::string_view b) const;
};

/// Names that differ only in one number belong together; where several numbers vary, the last one
/// counts the slices. Each stack is in natural order, as are the stacks.
std::vector<std::vector<std::string>> stacks_of_names(std::vector<std::string> names);

}  // namespace cutaway::reading
