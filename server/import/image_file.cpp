#include "import/image_file.h"

#include <dlfcn.h>

#include "import/image_module.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

/// Stays for as long as the process: libraries of this size do not bear being unloaded.
const ImageFunctions* load() {
  void* module = dlopen(kImageModule, RTLD_NOW | RTLD_LOCAL);
  if (!module) return nullptr;
  const auto functions =
      reinterpret_cast<decltype(&cutaway_image_functions)>(dlsym(module, kImageFunctions));
  return functions ? functions() : nullptr;
}

const ImageFunctions& module_for(const std::filesystem::path& file) {
  static const ImageFunctions* const loaded = load();
  if (!loaded) {
    refuse(file, "pictures cannot be read: a part of the program is missing",
           std::string(kImageModule) + " beside the program, and OpenImageIO");
  }
  return *loaded;
}

}  // namespace

ImageFile open_image_file(const std::filesystem::path& file) {
  return module_for(file).open(file);
}

void read_image_page(const std::filesystem::path& file, int page, const PixelLayout& layout,
                     std::span<std::byte> pixels) {
  module_for(file).read_page(file, page, layout, pixels);
}

}  // namespace cutaway::reading
