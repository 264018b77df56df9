// Which of a file's planes are slices, and planes that no directory of the file leads to.
#pragma once

#include "import/pictures/image_file.h"
#include "import/pictures/picture_text.h"

namespace cutaway::reading {

/// Sets the slices' pages: those that the text names, where it speaks of just the planes that are
/// there, else all; and says what was left out or assumed. Throws Error naming the file for pages
/// that differ, are too many, or are promised and not there.
void take_pages(const std::filesystem::path& file, const PictureText& text, ImageFile& image);

/// A plane behind the only one that has a directory, as stored. Throws Error naming the file.
void read_plane_behind(const std::filesystem::path& file, int plane, Component component,
                       std::span<std::byte> pixels);

}  // namespace cutaway::reading
