#include "import/pictures/planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <fstream>

#include "import/pictures/tiff_pages.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr int kMostPages = 32768;

/// Only a TIFF has several.
int count_directories(const std::filesystem::path& file) {
  const TiffPages pages = tiff_pages(file, kMostPages);
  if (pages.count > kMostPages) {
    refuse(file, "the file has too many pages", fmt::format("at most {}", kMostPages));
  }
  if (pages.first_that_differs) {
    refuse(file, fmt::format("page {} differs from the first in size or number type",
                             *pages.first_that_differs + 1));
  }
  return std::max(1, pages.count);
}

std::uint64_t page_bytes(const PixelLayout& layout) {
  return std::uint64_t(layout.size_px.x) * layout.size_px.y * layout.channels *
         component_bytes(layout.component);
}

/// ImageJ writes no directories but the first where the file grows beyond 4 GB; the other planes
/// follow its own.
int count_planes(const std::filesystem::path& file, const PictureText& text,
                 const PixelLayout& layout) {
  const int directories = count_directories(file);
  if (directories > 1 || !text.planes_follow_first || text.planes <= 1) return directories;
  if (text.planes > kMostPages)
    refuse(file, "the file has too many pages", fmt::format("at most {}", kMostPages));
  const auto pixels = plain_pixels(file);
  const auto there = double(std::filesystem::file_size(file)) - double(pixels ? pixels->begin : 0);
  if (pixels && there >= double(text.planes) * double(page_bytes(layout))) return text.planes;
  refuse(file, "the file's text promises planes that are not there",
         fmt::format("{} planes, each with a directory or all in one piece without compression",
                     text.planes),
         counted(static_cast<std::uint64_t>(directories), "directory", "directories"));
}

void warn_of_planes(const PictureText& text, std::vector<std::string>& warnings) {
  if (text.times_are_slices) {
    warnings.push_back(fmt::format(
        "the file calls its {} pages times, with one slice each; they were taken for slices",
        text.slice_pages.size()));
  }
  if (text.channels > 1)
    warnings.push_back(
        fmt::format("the file holds {} channels; the first is shown", text.channels));
  if (text.times > 1)
    warnings.push_back(fmt::format("the file holds {} times; the first is shown", text.times));
}

}  // namespace

void take_pages(const std::filesystem::path& file, const PictureText& text, ImageFile& image) {
  const int planes = count_planes(file, text, image.layout);
  const auto is_there = [&](int page) { return page >= 0 && page < planes; };
  if (text.planes == planes && std::ranges::all_of(text.slice_pages, is_there)) {
    image.slice_pages = text.slice_pages;
    warn_of_planes(text, image.warnings);
    return;
  }
  for (int page = 0; page < planes; ++page) image.slice_pages.push_back(page);
  if (planes == 1 || (text.channels == 1 && text.times == 1)) return;
  const auto words = [](int count, const char* noun) {
    return counted(static_cast<std::uint64_t>(count), noun);
  };
  image.warnings.push_back(fmt::format(
      "the file's text speaks of {} in {} and {}, but there are {}; all were taken for slices",
      words(text.planes, "plane"), words(text.channels, "channel"), words(text.times, "time"),
      planes));
}

void read_plane_behind(const std::filesystem::path& file, int plane, Component component,
                       std::span<std::byte> pixels) {
  const auto first = plain_pixels(file);
  if (!first) refuse(file, fmt::format("page {} is not there", plane + 1));
  std::ifstream input(file, std::ios::binary);
  input.seekg(static_cast<std::streamoff>(first->begin + std::uint64_t(plane) * pixels.size()));
  input.read(reinterpret_cast<char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
  if (!input) refuse(file, "the picture is broken or cut off");
  if (first->big_endian != (std::endian::native == std::endian::big))
    swap_byte_order(pixels, component_bytes(component));
}

}  // namespace cutaway::reading
