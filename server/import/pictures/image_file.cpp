#include "import/pictures/image_file.h"

#include <dlfcn.h>

#include "import/data_root.h"
#include "import/pictures/image_module.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

struct Module {
  const ImageFunctions* functions = nullptr;
  std::string failure;  ///< the linker's words
};

/// Stays for as long as the process: libraries of this size do not bear being unloaded.
Module load() {
  void* module = dlopen(kImageModule, RTLD_NOW | RTLD_LOCAL);
  void* entry = module ? dlsym(module, kImageFunctions) : nullptr;
  if (!entry) return {.functions = nullptr, .failure = dlerror()};
  return {.functions = reinterpret_cast<decltype(&cutaway_image_functions)>(entry)(),
          .failure = {}};
}

const ImageFunctions& module_for(const std::filesystem::path& file) {
  static const Module module = load();
  if (!module.functions) {
    refuse(file, "pictures cannot be read: a part of the program cannot be loaded",
           std::string(kImageModule) + " beside the program, and OpenImageIO",
           printable(module.failure));
  }
  return *module.functions;
}

}  // namespace

ImageFile open_image_file(const std::filesystem::path& file) { return module_for(file).open(file); }

void read_image_page(const std::filesystem::path& file, int page, const PixelLayout& layout,
                     std::span<std::byte> pixels) {
  module_for(file).read_page(file, page, layout, pixels);
}

}  // namespace cutaway::reading
