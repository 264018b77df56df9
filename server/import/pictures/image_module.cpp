#include "import/pictures/image_module.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "import/data_root.h"
#include "import/decompressor.h"
#include "import/length_unit.h"
#include "import/pictures/tiff_pages.h"
#include "import/refusal.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace {

constexpr int kMostPages = 32768;

std::unique_ptr<OIIO::ImageInput> open(const std::filesystem::path& file) {
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);  // else values come multiplied by alpha
  auto input = OIIO::ImageInput::open(file.string(), &as_stored);
  if (!input) refuse(file, "the picture is broken or cut off", {}, printable(OIIO::geterror()));
  return input;
}

Component component_of(const std::filesystem::path& file, const OIIO::ImageSpec& spec) {
  switch (spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return Component::uint8;
    case OIIO::TypeDesc::INT8:
      return Component::int8;
    case OIIO::TypeDesc::UINT16:
      return Component::uint16;
    case OIIO::TypeDesc::INT16:
      return Component::int16;
    case OIIO::TypeDesc::UINT32:
      return Component::uint32;
    case OIIO::TypeDesc::INT32:
      return Component::int32;
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
      return Component::float32;
    case OIIO::TypeDesc::DOUBLE:
      return Component::float64;
    default:
      break;
  }
  refuse(file, "this number type is not read", "8 to 32 bit integers or floats",
         spec.format.c_str());
}

OIIO::TypeDesc type_of(Component component) {
  constexpr std::array kTypes{OIIO::TypeDesc::INT8,   OIIO::TypeDesc::UINT8, OIIO::TypeDesc::INT16,
                              OIIO::TypeDesc::UINT16, OIIO::TypeDesc::INT32, OIIO::TypeDesc::UINT32,
                              OIIO::TypeDesc::FLOAT,  OIIO::TypeDesc::DOUBLE};
  return kTypes.at(static_cast<std::size_t>(component));
}

PixelLayout layout_of(const std::filesystem::path& file, const OIIO::ImageSpec& spec) {
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1) {
    refuse(file, "the picture has no usable size", "a width and a height above 0",
           fmt::format("{}x{}x{}", spec.width, spec.height, spec.depth));
  }
  return {{spec.width, spec.height},
          static_cast<std::size_t>(spec.nchannels),
          component_of(file, spec)};
}

/// The most that one byte of the file can become in one of the format's compressions. Fax codes and
/// the later ones of TIFF make next to nothing of an even picture.
double largest_ratio_of(const OIIO::ImageInput& input) {
  if (input.format_name() == std::string_view("png")) return largest_ratio(Compression::deflate);
  const std::string name(input.spec().get_string_attribute("compression"));
  if (name == "none") return 1.0;
  if (name == "zip") return largest_ratio(Compression::deflate);
  if (name == "packbits") return 64.0;
  if (name == "lzw") return 4096 * 8 / 12.0;  // a whole table in a code
  return 1e5;
}

/// The fewest bytes that the page at hand can take in its file. A byte may come from one bit, and
/// all of a colour from one bit of a palette; wider values from at least half their width.
double least_bytes_of_page(const OIIO::ImageInput& input, const PixelLayout& layout) {
  const std::size_t bytes = component_bytes(layout.component);
  const double pixel_bytes =
      bytes == 1 ? 1.0 / 8 : static_cast<double>(bytes * layout.channels) / 2;
  return pixel_bytes * layout.size_px.x * layout.size_px.y / largest_ratio_of(input);
}

void require_file_size(const std::filesystem::path& file, double least_bytes) {
  std::error_code failed;
  const auto available = static_cast<double>(std::filesystem::file_size(file, failed));
  if (failed) refuse(file, "the file cannot be read", {}, failed.message());
  if (available >= least_bytes) return;
  refuse(file, "the file is shorter than its header says",
         "at least " + bytes_in_words(std::ceil(least_bytes)), bytes_in_words(available));
}

/// A value from "name=value" lines, as ImageJ writes them into ImageDescription.
std::string described(const OIIO::ImageSpec& spec, std::string_view name) {
  const std::string text(spec.get_string_attribute("ImageDescription"));
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    if (line.starts_with(name) && line.size() > name.size() && line[name.size()] == '=') {
      return std::string(trimmed(line.substr(name.size() + 1)));
    }
    begin = end + 1;
  }
  return {};
}

bool is_positive(double number) { return std::isfinite(number) && number > 0; }

/// Resolution is pixels per unit; ImageJ's own unit stands for TIFF's "none".
void take_spacing(const OIIO::ImageSpec& spec, ImageFile& image) {
  const std::string named = described(spec, "unit");
  const auto unit_mm = millimetres_per(
      named.empty() ? std::string(spec.get_string_attribute("ResolutionUnit")) : named);
  if (!unit_mm) return;
  const double along_x = spec.get_float_attribute("XResolution", 0.0F);
  const double along_y = spec.get_float_attribute("YResolution", static_cast<float>(along_x));
  if (is_positive(along_x) && is_positive(along_y)) {
    image.pixel_spacing_mm = glm::dvec2(*unit_mm / along_x, *unit_mm / along_y);
  }
  const std::vector<double> between = numbers_of(described(spec, "spacing"));
  if (!between.empty() && is_positive(between.front()))
    image.slice_spacing_mm = between.front() * *unit_mm;
}

/// Only a TIFF has several.
int count_pages(const std::filesystem::path& file) {
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

/// Row by row where there are rows: several at once OpenImageIO also calls read where the file is
/// cut off or its compressed data are broken.
bool read_pixels(OIIO::ImageInput& input, const PixelLayout& layout, std::span<std::byte> pixels) {
  const OIIO::ImageSpec spec = input.spec();
  const OIIO::TypeDesc type = type_of(layout.component);
  if (spec.tile_width > 0) {
    return input.read_image(input.current_subimage(), 0, 0, spec.nchannels, type, pixels.data());
  }
  const std::size_t row_bytes = pixels.size() / static_cast<std::size_t>(spec.height);
  for (int row = 0; row < spec.height; ++row) {
    const auto target = pixels.subspan(static_cast<std::size_t>(row) * row_bytes, row_bytes);
    if (!input.read_scanline(spec.y + row, 0, type, target.data())) return false;
  }
  return true;
}

ImageFile open_pages(const std::filesystem::path& file) {
  const auto input = open(file);
  ImageFile image;
  image.layout = layout_of(file, input->spec());
  take_spacing(input->spec(), image);
  image.pages = count_pages(file);
  require_file_size(file, image.pages * least_bytes_of_page(*input, image.layout));
  return image;
}

void read_page(const std::filesystem::path& file, int page, const PixelLayout& layout,
               std::span<std::byte> pixels) {
  const auto input = open(file);
  const bool there = input->seek_subimage(page, 0);
  if (!there || layout_of(file, input->spec()) != layout) {
    refuse(file, fmt::format("page {} is not as the first, or not there", page + 1));
  }
  if (read_pixels(*input, layout, pixels)) return;
  refuse(file, "the picture is broken or cut off", {}, printable(input->geterror()));
}

}  // namespace

}  // namespace cutaway::reading

const cutaway::reading::ImageFunctions* cutaway_image_functions() {
  static constexpr cutaway::reading::ImageFunctions kFunctions{cutaway::reading::open_pages,
                                                               cutaway::reading::read_page};
  return &kFunctions;
}
