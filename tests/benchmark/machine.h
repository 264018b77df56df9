// What the figures were measured on.
#pragma once

#include <string>

namespace cutaway::benchmark {

struct Machine {
  std::string processor;  ///< as the system names it
  int cores = 0;          ///< that this process may use
  std::string renderer;   ///< GL_RENDERER
  bool software_renderer = false;
  std::string compiler;
};

/// Renderer left empty: that is the context's to tell.
Machine this_machine();

}  // namespace cutaway::benchmark
