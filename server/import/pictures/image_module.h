// The one part of the readers that uses OpenImageIO, loaded when the first picture is opened: the
// library brings some two hundred others with it, and a process that reads none of its formats
// would spend most of its start on linking them.
#pragma once

#include "import/pictures/image_file.h"

namespace cutaway::reading {

struct ImageFunctions {
  decltype(&open_image_file) open = nullptr;
  decltype(&read_image_page) read_page = nullptr;
};

/// By this name the module is found beside the program, and its functions in the module.
inline constexpr const char* kImageModule = "cutaway-images.so";
inline constexpr const char* kImageFunctions = "cutaway_image_functions";

}  // namespace cutaway::reading

extern "C" const cutaway::reading::ImageFunctions* cutaway_image_functions();
