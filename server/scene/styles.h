// The named styles of server/styles, which travel inside the program.
#pragma once

#include <string>
#include <vector>

#include "scene/json.h"

namespace cutaway {

struct Style {
  std::string name;
  std::string title;
  std::string description;
  std::string group;  ///< "illustration" or "study"
  Json scene;         ///< partial: a whole look, so merging one style replaces another
};

/// In the order of the list in this folder's CMakeLists.txt: the flagship first. Thread-safe.
const std::vector<Style>& styles();

/// Throws Error unknown-style with the names that there are.
const Style& style(const std::string& name);

/// The `styles` part of `capabilities`.
Json describe_styles();

}  // namespace cutaway
