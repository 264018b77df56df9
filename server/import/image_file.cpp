#include "import/image_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "import/data_root.h"
#include "import/refusal.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace {

constexpr int kMostPages = 32768;

std::unique_ptr<OIIO::ImageInput> open(const std::filesystem::path& file) {
  auto input = OIIO::ImageInput::open(file.string());
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

std::optional<double> millimetres_of(std::string_view unit) {
  if (unit == "in" || unit == "inch") return 25.4;
  if (unit == "m") return 1000.0;
  if (unit == "cm") return 10.0;
  if (unit == "mm") return 1.0;
  if (unit == "um" || unit == "micron" || unit == "\\u00B5m" || unit == "\xC2\xB5m") return 0.001;
  return std::nullopt;
}

bool is_positive(double number) { return std::isfinite(number) && number > 0; }

/// Resolution is pixels per unit; ImageJ's own unit stands for TIFF's "none".
void take_spacing(const OIIO::ImageSpec& spec, ImageFile& image) {
  const std::string named = described(spec, "unit");
  const auto unit_mm = millimetres_of(
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

}  // namespace

ImageFile open_image_file(const std::filesystem::path& file) {
  const auto input = open(file);
  ImageFile image;
  image.layout = layout_of(file, input->spec());
  take_spacing(input->spec(), image);
  for (; image.pages < kMostPages && input->seek_subimage(image.pages, 0); ++image.pages) {
    if (layout_of(file, input->spec()) != image.layout) {
      refuse(file,
             fmt::format("page {} differs from the first in size or number type", image.pages + 1));
    }
  }
  return image;
}

void read_image_page(const std::filesystem::path& file, int page, const PixelLayout& layout,
                     std::span<std::byte> pixels) {
  const auto input = open(file);
  const bool there = input->seek_subimage(page, 0);
  if (!there || layout_of(file, input->spec()) != layout) {
    refuse(file, "the file changed while it was read");
  }
  const bool read = input->read_image(page, 0, 0, static_cast<int>(layout.channels),
                                      type_of(layout.component), pixels.data());
  if (!read) refuse(file, "the picture is broken or cut off", {}, printable(input->geterror()));
}

}  // namespace cutaway::reading
