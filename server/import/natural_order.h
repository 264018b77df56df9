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

/// Names that differ only in one number belong together. Where several vary, the one behind "z",
/// "slice" or the like counts the slices, else the last that does not follow the word for a channel
/// or a time ("c", "ch", "w", "t"). Each stack is in natural order, as are the stacks.
std::vector<std::vector<std::string>> stacks_of_names(std::vector<std::string> names);

}  // namespace cutaway::reading
