#include "import/format_table.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "import/data_root.h"
#include "import/dicom/header.h"
#include "import/grids/grid_file.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

using Files = std::span<const fs::path>;
using OpenGrid = decltype(&open_nifti);

/// A scan that goes on after one that broke down among the series looks for none.
Listing find_dicom_unless_refused(Files files, const ScanContext& context) {
  if (!context.dicom_refused) return find_dicom(files, context);
  if (files.empty()) return {};
  const fs::path place = files.size() == 1 ? files.front() : common_folder(files);
  return {.volumes = {}, .refused = {{place, *context.dicom_refused}}};
}

template <OpenGrid open>
Listing find_grids(Files files, const ScanContext& context) {
  Listing listing;
  for (const auto& file : files) {
    try {
      listing.volumes.push_back(context.look_into(
          file, [&] { return source_of(open(file, context.root, context.limits), context); }));
    } catch (const Error& error) {
      listing.refused.push_back({file, reason_of(error)});
    }
  }
  return listing;
}

/// The header comes first among a source's files; data may only lie where the scan found them, or
/// beside.
template <OpenGrid open>
RawVolume read_grid(const VolumeSource& source, const ReadContext& context) {
  const GridFile grid = open(source.files.front(), common_folder(source.files), context.limits);
  return read_grid_file(grid, source, context);
}

/// Whether the file has these bytes there.
bool has_bytes(const fs::path& file, std::streamoff offset, std::string_view bytes) {
  std::string found(bytes.size(), '\0');
  std::ifstream input(file, std::ios::binary);
  input.seekg(offset);
  return input.read(found.data(), static_cast<std::streamsize>(found.size())) && found == bytes;
}

bool has_nifti_mark(const fs::path& file) {
  return has_bytes(file, 344, std::string_view("n+1\0", 4)) ||
         has_bytes(file, 4, std::string_view("n+2\0\r\n\032\n", 8));
}

bool has_nrrd_mark(const fs::path& file) { return has_bytes(file, 0, "NRRD000"); }

template <typename... Ending>
constexpr auto endings(Ending... ending) {
  return std::array<std::string_view, sizeof...(Ending)>{ending...};
}

constexpr auto kDicom = endings(".dcm", ".dicom", ".ima");
// A .hdr may be many things; a .gz almost anything.
constexpr auto kNifti = endings(".nii", ".nii.gz", ".hdr", ".hdr.gz");
constexpr auto kNrrd = endings(".nrrd", ".nhdr");
constexpr auto kMetaImage = endings(".mha", ".mhd");
constexpr auto kPictures = endings(".tif", ".tiff", ".png");

// In this order they are looked for: DICOM last, whose library breaks down at most damaged files.
constexpr std::array kTable{
    Format{"NIfTI", kNifti, has_nifti_mark, find_grids<open_nifti>, read_grid<open_nifti>},
    Format{"NRRD", kNrrd, has_nrrd_mark, find_grids<open_nrrd>, read_grid<open_nrrd>},
    Format{"MetaImage", kMetaImage, nullptr, find_grids<open_metaimage>, read_grid<open_metaimage>},
    Format{"image stack", kPictures, nullptr, find_image_stacks, read_image_stack},
    Format{"DICOM", kDicom, looks_like_dicom, find_dicom_unless_refused, read_dicom}};

}  // namespace

std::span<const Format> format_table() { return kTable; }

const Format* format_of(const fs::path& file) {
  const std::string name = lower_case(file.filename().string());
  for (const Format& format : kTable) {
    const auto fits = [&](std::string_view ending) { return name.ends_with(ending); };
    if (std::ranges::any_of(format.endings, fits)) return &format;
  }
  for (const Format& format : kTable) {
    if (format.has_mark && format.has_mark(file)) return &format;
  }
  return nullptr;
}

const Format* format_named(std::string_view name) {
  const auto found = std::ranges::find(kTable, name, &Format::name);
  return found == kTable.end() ? nullptr : &*found;
}

std::string formats_in_words() {
  std::string words;
  for (const Format& format : kTable) {
    if (!words.empty()) words += ", ";
    words += format.name;
  }
  return words;
}

}  // namespace cutaway::reading
