// TIFF and PNG pictures, through OpenImageIO, which a module brings along (image_module.h). Any
// thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/raw_voxels.h"

namespace cutaway::reading {

/// What is the same for all pages of a file, and of a stack.
struct PixelLayout {
  glm::ivec2 size_px{0};
  std::size_t channels = 1;
  Component component = Component::uint8;
  bool operator==(const PixelLayout&) const = default;
};

struct ImageFile {
  PixelLayout layout;            ///< as it is to be seen: turned by the file's orientation
  std::vector<int> slice_pages;  ///< which page each slice is; at least one
  std::optional<glm::dvec2>
      pixel_spacing_mm;                    ///< from its resolution, where that has a unit of length
  std::optional<double> slice_spacing_mm;  ///< from ImageJ's or OME's text
  std::vector<std::string> warnings;
};

/// Reads headers only. Throws Error naming the file where it is broken, or too short for the pixels
/// that it declares, where its pages differ or are too many, or for a number type that is not read.
ImageFile open_image_file(const std::filesystem::path& file);

/// One page's pixels as they are to be seen, never multiplied by alpha; channels interleaved, in
/// the layout's number type. Throws Error naming the file.
void read_image_page(const std::filesystem::path& file, int page, const PixelLayout& layout,
                     std::span<std::byte> pixels);

}  // namespace cutaway::reading
