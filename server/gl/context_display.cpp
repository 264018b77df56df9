#include "gl/context_display.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace cutaway::gl {

namespace {

bool has_extension(const char* list, std::string_view wanted) {
  return list != nullptr && std::string_view(list).find(wanted) != std::string_view::npos;
}

std::vector<EGLDeviceEXT> devices() {
  std::array<EGLDeviceEXT, 64> found{};
  EGLint count = 0;
  if (eglQueryDevicesEXT(static_cast<EGLint>(found.size()), found.data(), &count) != EGL_TRUE)
    return {};
  return {found.begin(), found.begin() + count};
}

bool is_software_device(EGLDeviceEXT device) {
  return has_extension(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

}  // namespace

std::vector<DisplayCandidate> find_display_candidates() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<DisplayCandidate> candidates;
  // The EXT entry points: the EGL 1.5 names are refused before a display exists.
  if (has_extension(client, "EGL_EXT_device_enumeration") &&
      has_extension(client, "EGL_EXT_platform_device")) {
    int index = 0;
    for (EGLDeviceEXT device : devices()) {
      candidates.push_back({eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr),
                            "device " + std::to_string(index++), is_software_device(device)});
    }
  }
  if (has_extension(client, "EGL_MESA_platform_surfaceless")) {
    candidates.push_back({eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr),
                          "surfaceless", true});
  }
  std::erase_if(candidates,
                [](const auto& candidate) { return candidate.display == EGL_NO_DISPLAY; });
  std::ranges::stable_sort(candidates, {}, &DisplayCandidate::software);
  return candidates;
}

}  // namespace cutaway::gl
