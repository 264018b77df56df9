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
#include "import/pictures/orientation.h"
#include "import/pictures/picture_text.h"
#include "import/pictures/planes.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

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

bool is_positive(double number) { return std::isfinite(number) && number > 0; }

std::string text_of(const OIIO::ImageSpec& spec) {
  return std::string(spec.get_string_attribute("ImageDescription"));
}

/// From the text's unit; that of ImageJ stands for TIFF's "none".
std::optional<double> unit_mm(const OIIO::ImageSpec& spec, const std::string& named,
                              std::vector<std::string>& warnings) {
  if (named.empty())
    return millimetres_per(std::string(spec.get_string_attribute("ResolutionUnit")));
  const auto unit = millimetres_per(named);
  if (!unit && !is_no_length(named)) {
    std::string warning =
        fmt::format("the unit of length \"{}\" is not known", quoted_briefly(printable(named)));
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(std::move(warning));
  }
  return unit;
}

/// A spacing in the text, else the resolution, which is pixels per unit.
void take_spacing(const OIIO::ImageSpec& spec, const PictureText& text, ImageFile& image) {
  std::array<std::optional<double>, 3> unit;
  for (std::size_t axis = 0; axis < 3; ++axis)
    unit[axis] = unit_mm(spec, text.units[axis], image.warnings);
  const double along_x = spec.get_float_attribute("XResolution", 0.0F);
  const std::array resolution{
      along_x, double(spec.get_float_attribute("YResolution", static_cast<float>(along_x)))};
  glm::dvec2 spacing(0.0);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = text.spacings[axis].value_or(1.0 / resolution[axis]);
    spacing[static_cast<int>(axis)] = length * unit[axis].value_or(0.0);
  }
  if (is_positive(spacing.x) && is_positive(spacing.y)) image.pixel_spacing_mm = spacing;
  const double between = text.spacings[2].value_or(0.0) * unit[2].value_or(0.0);
  if (is_positive(between)) image.slice_spacing_mm = between;
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

Orientation orientation_of(const OIIO::ImageSpec& spec) {
  return tiff_orientation(spec.get_int_attribute("Orientation", 1));
}

PixelLayout seen_layout(const std::filesystem::path& file, const OIIO::ImageSpec& spec) {
  PixelLayout layout = layout_of(file, spec);
  if (orientation_of(spec).transposed) std::swap(layout.size_px.x, layout.size_px.y);
  return layout;
}

ImageFile open_pages(const std::filesystem::path& file) {
  const auto input = open(file);
  const OIIO::ImageSpec spec = input->spec();
  const PictureText text = read_picture_text(text_of(spec));
  ImageFile image;
  image.layout = seen_layout(file, spec);
  take_spacing(spec, text, image);
  if (orientation_of(spec).transposed && image.pixel_spacing_mm)
    std::swap(image.pixel_spacing_mm->x, image.pixel_spacing_mm->y);
  take_pages(file, text, image);
  require_file_size(file,
                    double(image.slice_pages.size()) * least_bytes_of_page(*input, image.layout));
  return image;
}

void read_page(const std::filesystem::path& file, int page, const PixelLayout& layout,
               std::span<std::byte> pixels) {
  const auto input = open(file);
  const OIIO::ImageSpec first = input->spec();
  if (seen_layout(file, first) == layout && !input->seek_subimage(page, 0) &&
      read_picture_text(text_of(first)).planes_follow_first) {
    read_plane_behind(file, page, layout.component, pixels);
    return turn(orientation_of(first), layout, pixels);
  }
  if (input->current_subimage() != page || seen_layout(file, input->spec()) != layout) {
    refuse(file, fmt::format("page {} is not as the first, or not there", page + 1));
  }
  PixelLayout stored = layout_of(file, input->spec());
  if (!read_pixels(*input, stored, pixels))
    refuse(file, "the picture is broken or cut off", {}, printable(input->geterror()));
  turn(orientation_of(input->spec()), layout, pixels);
}

}  // namespace

}  // namespace cutaway::reading

const cutaway::reading::ImageFunctions* cutaway_image_functions() {
  static constexpr cutaway::reading::ImageFunctions kFunctions{cutaway::reading::open_pages,
                                                               cutaway::reading::read_page};
  return &kFunctions;
}
