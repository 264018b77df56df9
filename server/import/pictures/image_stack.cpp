#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "import/data_root.h"
#include "import/formats.h"
#include "import/natural_order.h"
#include "import/pictures/image_file.h"
#include "import/pictures/sidecar.h"
#include "import/refusal.h"
#include "import/slice_grid.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

/// The pictures of one volume: pages of one file, or files in order.
struct Stack {
  std::vector<fs::path> files;
  ImageFile first;
  Sidecar sidecar;
  SliceStack slices;
  GridPlan plan;
  std::vector<std::string> warnings;

  int slice_count() const {
    return static_cast<int>(files.size() == 1 ? first.slice_pages.size() : files.size());
  }
};

using OpenPicture = std::function<ImageFile(const fs::path&)>;

/// All pictures of a stack have one size and number type.
void open_pictures(Stack& stack, const OpenPicture& open) {
  stack.first = open(stack.files.front());
  if (stack.files.size() == 1) return;
  for (const auto& file : stack.files) {
    const ImageFile image = open(file);
    if (image.slice_pages.size() > 1)
      refuse(file, "one picture of the stack has several pages", "one page");
    if (image.layout != stack.first.layout) {
      refuse(file, "the picture differs from the first of its stack in size or number type",
             fmt::format("{}x{}", stack.first.layout.size_px.x, stack.first.layout.size_px.y),
             fmt::format("{}x{}", image.layout.size_px.x, image.layout.size_px.y));
    }
  }
}

/// From the sidecar, else from the pictures, else 1 mm; what was assumed is said.
glm::dvec3 spacing_of(Stack& stack) {
  if (stack.sidecar.spacing_mm) return *stack.sidecar.spacing_mm;
  if (!stack.first.pixel_spacing_mm) {
    stack.warnings.emplace_back(
        "neither the pictures nor a volume.json give a spacing; 1 mm was taken");
    return glm::dvec3(1.0);
  }
  const glm::dvec2 in_plane = *stack.first.pixel_spacing_mm;
  if (stack.first.slice_spacing_mm) return {in_plane, *stack.first.slice_spacing_mm};
  stack.warnings.push_back(fmt::format(
      "the pictures give no distance between slices; that of their rows, {:.6g} mm, was taken",
      in_plane.y));
  return {in_plane, in_plane.y};
}

void warn_of_channels(std::size_t channels, std::vector<std::string>& warnings) {
  if (channels == 2) warnings.emplace_back("the second channel (alpha) was left out");
  if (channels == 3) warnings.emplace_back("colour was reduced to its luminance");
  if (channels == 4)
    warnings.emplace_back(
        "colour was reduced to its luminance; the fourth channel (alpha) was left out");
  if (channels > 4) {
    warnings.push_back(fmt::format(
        "the first 3 of {} channels were reduced to their luminance; the others were left out",
        channels));
  }
}

void lay_out(Stack& stack, const ImportLimits& limits) {
  const PixelLayout& layout = stack.first.layout;
  const glm::ivec3 size(layout.size_px, stack.slice_count());
  const std::size_t voxel_bytes = component_bytes(layout.component) * layout.channels;
  const fs::path& file = stack.files.front();
  checked_voxel_count(file, std::array<std::int64_t, 3>{size.x, size.y, size.z}, voxel_bytes,
                      limits);
  const glm::dvec3 spacing = spacing_of(stack);
  glm::dmat3 steps = stack.sidecar.direction_lps;
  for (int axis = 0; axis < 3; ++axis) steps[axis] *= spacing[axis];
  stack.slices = stack_of_affine(size, steps, stack.sidecar.origin_lps_mm);
  stack.plan = plan_grid(file, stack.slices, voxel_bytes, limits);
  stack.warnings.insert(stack.warnings.end(), stack.plan.warnings.begin(),
                        stack.plan.warnings.end());
  warn_of_channels(layout.channels, stack.warnings);
}

/// A link could lead out of the data folder.
void take_sidecar(Stack& stack) {
  const fs::path sidecar = stack.files.front().parent_path() / kSidecarName;
  std::error_code failed;
  if (fs::is_symlink(sidecar, failed)) {
    stack.warnings.emplace_back("volume.json is a link and was not followed");
  } else if (fs::is_regular_file(sidecar, failed)) {
    stack.sidecar = read_sidecar(sidecar);
    stack.warnings = stack.sidecar.warnings;
  }
}

Stack open_stack(std::vector<fs::path> files, const ImportLimits& limits, const OpenPicture& open) {
  Stack stack;
  stack.files = std::move(files);
  open_pictures(stack, open);
  take_sidecar(stack);
  stack.warnings.insert(stack.warnings.end(), stack.first.warnings.begin(),
                        stack.first.warnings.end());
  lay_out(stack, limits);
  return stack;
}

VolumeDescription describe(const Stack& stack, const fs::path& named_by, const fs::path& root) {
  const std::string name = fs::is_directory(named_by) ? named_by.filename() : named_by.stem();
  const std::string modality = stack.sidecar.modality.value_or("");
  return {.id = volume_id(named_by, root),
          .title = stack.sidecar.title.value_or(printable(name)),
          .format = "image stack",
          .modality = modality,
          .units = stack.sidecar.units.value_or("none"),
          .warnings = stack.warnings};
}

/// A file that cannot be opened counts as one picture, so that it is its stack that is refused.
bool has_pages(const fs::path& file, const OpenPicture& open) {
  if (!lower_case(file.extension().string()).starts_with(".tif")) return false;
  try {
    return open(file).slice_pages.size() > 1;
  } catch (const Error&) {
    return false;
  }
}

RefusedFile refused_stack(const std::vector<fs::path>& files, const Error& error) {
  const std::string& broken = error.detail().field;
  std::string reason = reason_of(error);
  if (files.size() > 1) {
    reason +=
        fmt::format("; so the stack of {} pictures that it belongs to is not read", files.size());
  }
  return {broken.empty() ? files.front() : fs::path(broken), reason};
}

/// Of one folder and one file type: multi-page files by themselves, the others by their names; with
/// a sidecar all together.
std::vector<std::vector<fs::path>> stacks_of_folder(const fs::path& folder,
                                                    const std::vector<std::string>& names,
                                                    const OpenPicture& open) {
  std::error_code failed;
  std::vector<std::string> singles;
  std::vector<std::vector<fs::path>> stacks;
  for (const auto& name : names) {
    const bool paged = has_pages(folder / name, open);
    if (paged) stacks.push_back({folder / name});
    if (!paged) singles.push_back(name);
  }
  std::vector<std::vector<std::string>> by_name;
  const bool described = fs::is_regular_file(fs::symlink_status(folder / kSidecarName, failed));
  if (described && !singles.empty()) {
    std::sort(singles.begin(), singles.end(), NaturalOrder());
    by_name = {singles};
  } else {
    by_name = stacks_of_names(singles);
  }
  for (const auto& members : by_name) {
    std::vector<fs::path>& stack = stacks.emplace_back();
    for (const auto& name : members) stack.push_back(folder / name);
  }
  return stacks;
}

void find_in_folder(const fs::path& folder, const std::vector<std::string>& names,
                    const ScanContext& context, Listing& listing) {
  const OpenPicture open = [&](const fs::path& file) {
    return context.look_into(file, [&file] { return open_image_file(file); });
  };
  const auto stacks = stacks_of_folder(folder, names, open);
  for (const auto& files : stacks) {
    const fs::path named_by = files.size() > 1 && stacks.size() == 1 ? folder : files.front();
    try {
      const Stack stack = open_stack(files, context.limits, open);
      listing.volumes.push_back(
          {describe(stack, named_by, context.root), stack.plan.geometry, files});
    } catch (const Error& error) {
      listing.refused.push_back(refused_stack(files, error));
    }
  }
}

}  // namespace

Listing find_image_stacks(std::span<const fs::path> files, const ScanContext& context) {
  std::map<std::pair<fs::path, std::string>, std::vector<std::string>> by_folder_and_type;
  for (const auto& file : files) {
    const bool tiff = lower_case(file.extension().string()).starts_with(".tif");
    by_folder_and_type[{file.parent_path(), tiff ? "tiff" : "png"}].push_back(
        file.filename().string());
  }
  Listing listing;
  for (const auto& [place, names] : by_folder_and_type) {
    find_in_folder(place.first, names, context, listing);
  }
  return listing;
}

namespace {

/// Page after page; one of several channels is reduced before the next is read.
RawVoxels read_pages(const Stack& stack, const ReadContext& context) {
  const PixelLayout& layout = stack.first.layout;
  const auto slices = static_cast<std::size_t>(stack.slice_count());
  const std::size_t slice_values = std::size_t(layout.size_px.x) * layout.size_px.y;
  const std::size_t slice_bytes = slice_values * component_bytes(layout.component);
  const bool paged = stack.files.size() == 1;
  RawVoxels voxels = make_raw_voxels(layout.component, slice_values * slices);
  RawVoxels page;
  for (std::size_t k = 0; k < slices; ++k) {
    throw_if_cancelled(context.stop);
    const auto target = bytes_of(voxels).subspan(k * slice_bytes, slice_bytes);
    if (layout.channels > 1)
      page = make_raw_voxels(layout.component, slice_values * layout.channels);
    read_image_page(stack.files[paged ? 0 : k], stack.first.slice_pages[paged ? k : 0], layout,
                    layout.channels > 1 ? bytes_of(page) : target);
    if (layout.channels > 1) {
      reduce_channels(page, layout.channels, Channels::colour);
      std::ranges::copy(bytes_of(page), target.begin());
    }
    if (context.progress)
      context.progress(LoadStage::decode, static_cast<double>(k + 1) / static_cast<double>(slices));
  }
  return voxels;
}

}  // namespace

RawVolume read_image_stack(const VolumeSource& source, const ReadContext& context) {
  const auto open = [&](const fs::path& file) {
    throw_if_cancelled(context.stop);
    return open_image_file(file);
  };
  const Stack stack = open_stack(source.files, context.limits, open);
  if (context.progress) context.progress(LoadStage::read, 1.0);
  RawVolume raw;
  raw.description = source.description;
  raw.description.warnings = stack.warnings;
  raw.geometry = stack.plan.geometry;
  raw.slope = stack.sidecar.slope;
  raw.intercept = stack.sidecar.intercept;
  raw.voxels = read_pages(stack, context);
  if (stack.plan.needs_resampling) {
    raw.voxels = resample(std::move(raw.voxels), stack.slices, stack.plan,
                          {.slope = raw.slope, .intercept = raw.intercept}, context.stop);
  }
  return raw;
}

}  // namespace cutaway::reading
