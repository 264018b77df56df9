// The EGL displays on which a context could be made, best first.
#pragma once

#include <epoxy/egl.h>

#include <string>
#include <vector>

namespace cutaway::gl {

struct DisplayCandidate {
  EGLDisplay display = EGL_NO_DISPLAY;
  std::string name;       ///< for logs: "device 0", "surfaceless"
  bool software = false;  ///< as far as EGL tells before a context exists
};

/// Hardware devices first; none of them is initialised yet.
std::vector<DisplayCandidate> find_display_candidates();

}  // namespace cutaway::gl
