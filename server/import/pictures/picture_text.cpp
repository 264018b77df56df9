#include "import/pictures/picture_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "import/data_root.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace {

constexpr std::int64_t kMostPlanes = std::int64_t{1} << 30;

/// One of the dimensions that pages run through, fastest first.
struct Dimension {
  char name;  ///< 'C', 'Z' or 'T'
  int size;
};
using Dimensions = std::vector<Dimension>;

int size_of(const Dimensions& dimensions, char name) {
  int size = 1;
  for (const auto& [each, extent] : dimensions) size *= each == name ? extent : 1;
  return size;
}

/// The pages of the first of everything but depth.
void take_dimensions(Dimensions dimensions, PictureText& text) {
  std::int64_t planes = 1;
  for (const auto& dimension : dimensions) {
    if (dimension.size < 1 || dimension.size > kMostPlanes / planes) return;
    planes *= dimension.size;
  }
  if (size_of(dimensions, 'Z') == 1 && size_of(dimensions, 'T') > 1) {
    text.times_are_slices = true;
    std::erase_if(dimensions, [](const Dimension& each) { return each.name == 'Z'; });
    for (Dimension& each : dimensions) each.name = each.name == 'T' ? 'Z' : each.name;
  }
  text.planes = static_cast<int>(planes);
  text.channels = size_of(dimensions, 'C');
  text.times = size_of(dimensions, 'T');
  int step = 1;
  for (const auto& [name, size] : dimensions) {
    if (name == 'Z') {
      for (int k = 0; k < size; ++k) text.slice_pages.push_back(k * step);
      return;
    }
    step *= size;
  }
  text.slice_pages = {0};
}

/// A value from "name=value" lines.
std::string line_value(std::string_view text, std::string_view name) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.starts_with(name) && line.size() > name.size() && line[name.size()] == '=')
      return std::string(trimmed(line.substr(name.size() + 1)));
    begin = end + 1;
  }
  return {};
}

int count_in(const std::string& word, int otherwise) {
  const auto number = integer_of(word);
  return number && *number >= 1 && *number < kMostPlanes ? static_cast<int>(*number) : otherwise;
}

std::optional<double> positive(const std::string& word) {
  const auto number = real_of(word);
  if (!number || !std::isfinite(*number) || *number == 0) return std::nullopt;
  return std::abs(*number);  // ImageJ writes a negative one for a stack that runs down
}

PictureText of_imagej(std::string_view description) {
  PictureText text;
  const int images = count_in(line_value(description, "images"), 1);
  const int channels = count_in(line_value(description, "channels"), 1);
  const int times = count_in(line_value(description, "frames"), 1);
  const int slices = count_in(line_value(description, "slices"),
                              std::max(1, images / std::max(1, channels * times)));
  take_dimensions({{'C', channels}, {'Z', slices}, {'T', times}}, text);
  text.planes_follow_first = true;
  const std::string unit = line_value(description, "unit");
  const auto along = [&](const char* name) {
    const std::string own = line_value(description, name);
    return own.empty() ? unit : own;
  };
  text.units = {unit, along("yunit"), along("zunit")};
  text.spacings[2] = positive(line_value(description, "spacing"));
  return text;
}

/// The start tags of that name, each without its brackets.
std::vector<std::string_view> tags_of(std::string_view xml, std::string_view name) {
  std::vector<std::string_view> tags;
  for (std::size_t at = xml.find('<'); at != std::string_view::npos; at = xml.find('<', at + 1)) {
    std::string_view tag = xml.substr(at + 1, xml.find('>', at) - at - 1);
    const std::size_t word = tag.find_first_of(" \t\r\n/");
    std::string_view called = tag.substr(0, word);
    if (const auto colon = called.find(':'); colon != std::string_view::npos)
      called.remove_prefix(colon + 1);  // a namespace
    if (called == name) tags.push_back(tag);
  }
  return tags;
}

std::string attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const std::string_view rest = trimmed(tag.substr(at + name.size()));
    const bool whole =
        at > 0 && std::string_view(" \t\r\n").find(tag[at - 1]) != std::string_view::npos;
    if (!whole || !rest.starts_with('=')) continue;
    const std::string_view value = trimmed(rest.substr(1));
    if (value.empty() || (value[0] != '"' && value[0] != '\'')) continue;
    return std::string(value.substr(1, value.find(value[0], 1) - 1));
  }
  return {};
}

/// Where TiffData elements place planes otherwise than in order. Only a full set of slices counts.
void take_tiff_data(std::string_view image, std::size_t slices, PictureText& text) {
  std::vector<int> pages(slices, -1);
  for (const std::string_view tag : tags_of(image, "TiffData")) {
    const auto number = [&](const char* name) {
      return integer_of(attribute(tag, name)).value_or(0);
    };
    const std::int64_t slice = number("FirstZ");
    const bool first = number("FirstC") == 0 && number("FirstT") == 0;
    if (!first || slice < 0 || std::cmp_greater_equal(slice, slices)) continue;
    const std::int64_t page = number("IFD");
    if (page >= 0 && page < kMostPlanes)
      pages[static_cast<std::size_t>(slice)] = static_cast<int>(page);
  }
  if (std::ranges::find(pages, -1) == pages.end()) text.slice_pages = std::move(pages);
}

PictureText of_ome(std::string_view xml) {
  PictureText text;
  const std::size_t image_end = xml.find("</Pixels>");
  const std::string_view image = xml.substr(0, image_end);  // the first of several
  const auto tags = tags_of(image, "Pixels");
  if (tags.empty()) return text;
  const std::string_view pixels = tags.front();
  const auto channels = tags_of(image, "Channel");
  const int samples =
      channels.empty() ? 1 : count_in(attribute(channels.front(), "SamplesPerPixel"), 1);
  Dimensions dimensions;
  for (const char name : attribute(pixels, "DimensionOrder")) {
    if (name != 'Z' && name != 'C' && name != 'T') continue;
    const int size = count_in(attribute(pixels, std::string("Size") + name), 1);
    dimensions.push_back({name, name == 'C' ? std::max(1, size / samples) : size});
  }
  take_dimensions(dimensions, text);
  if (text.slice_pages.size() > 1 && !text.times_are_slices)
    take_tiff_data(image, text.slice_pages.size(), text);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name = std::string("PhysicalSize") + "XYZ"[axis];
    text.spacings[axis] = positive(attribute(pixels, name));
    text.units[axis] = attribute(pixels, name + "Unit");
    if (text.spacings[axis] && text.units[axis].empty()) text.units[axis] = "um";
  }
  return text;
}

/// The text between two marks, the first such behind `key`.
std::string_view between(std::string_view text, std::string_view key, char open, char close) {
  const std::size_t found = text.find(key);
  if (found == std::string_view::npos) return {};
  const std::size_t begin = text.find(open, found + key.size());
  if (begin == std::string_view::npos) return {};
  const std::size_t end = text.find(close, begin + 1);
  return text.substr(begin + 1, end - begin - 1);
}

/// {"shape": [10, 3, 20, 24], "axes": "ZCYX"}: slowest first. What it calls otherwise, Q or I, may
/// be anything, and no depth.
PictureText of_tifffile(std::string_view json) {
  PictureText text;
  std::string sizes(between(json, "\"shape\"", '[', ']'));
  std::replace(sizes.begin(), sizes.end(), ',', ' ');
  const std::vector<std::string> words = words_of(sizes);
  const std::string_view names = between(json, "\"axes\"", '"', '"');
  if (names.empty() || names.size() != words.size()) return text;
  Dimensions dimensions;
  for (std::size_t i = names.size(); i-- > 0;) {
    if (std::string_view("YXS").find(names[i]) != std::string_view::npos) continue;
    const char name = names[i] == 'Z' || names[i] == 'T' ? names[i] : 'C';
    dimensions.push_back({name, count_in(words[i], 0)});
  }
  take_dimensions(dimensions, text);
  return text;
}

}  // namespace

PictureText read_picture_text(std::string_view description) {
  if (description.starts_with("ImageJ=")) return of_imagej(description);
  if (description.find("<OME") != std::string_view::npos ||
      description.find(":OME") != std::string_view::npos) {
    return of_ome(description);
  }
  if (trimmed(description).starts_with('{')) return of_tifffile(description);
  return {};
}

}  // namespace cutaway::reading
