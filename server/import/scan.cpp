#include "import/scan.h"

#include <algorithm>
#include <set>

#include "core/check.h"
#include "import/data_root.h"
#include "import/dicom/frame.h"
#include "import/dicom/header.h"
#include "import/formats.h"
#include "import/grids/grid_file.h"
#include "import/pictures/image_file.h"
#include "import/refusal.h"

namespace cutaway {

namespace fs = std::filesystem;
using namespace reading;

namespace {

enum class FileKind { none, dicom, nifti, nrrd, metaimage, picture };

/// A .hdr may be many things; a .gz almost anything.
bool is_nifti_name(const std::string& name) {
  return name.ends_with(".nii") || name.ends_with(".nii.gz") || name.ends_with(".hdr") ||
         name.ends_with(".hdr.gz");
}

FileKind kind_by_name(const fs::path& file) {
  const std::string name = lower_case(file.filename().string());
  const auto ends_with_one_of = [&](auto... endings) { return (name.ends_with(endings) || ...); };
  if (ends_with_one_of(".dcm", ".dicom", ".ima")) return FileKind::dicom;
  if (is_nifti_name(name)) return FileKind::nifti;
  if (ends_with_one_of(".nrrd", ".nhdr")) return FileKind::nrrd;
  if (ends_with_one_of(".mha", ".mhd")) return FileKind::metaimage;
  if (ends_with_one_of(".tif", ".tiff", ".png")) return FileKind::picture;
  return FileKind::none;
}

bool is_grid(FileKind kind) {
  return kind == FileKind::nifti || kind == FileKind::nrrd || kind == FileKind::metaimage;
}

class Walk {
 public:
  explicit Walk(ScanContext context) : context_(std::move(context)) {}

  Listing run(const fs::path& path) {
    if (fs::is_directory(path)) {
      walk_folder(path);
    } else {
      sort_file(path);
    }
    if (context_.is_trial) return {};
    add_dicom(path);
    add(find_image_stacks(pictures_, context_));
    std::sort(listing_.volumes.begin(), listing_.volumes.end(),
              [](const auto& a, const auto& b) { return a.description.id < b.description.id; });
    std::sort(listing_.refused.begin(), listing_.refused.end(),
              [](const auto& a, const auto& b) { return a.path < b.path; });
    make_ids_unique();
    return std::move(listing_);
  }

 private:
  /// Hidden files are passed over; links are followed to files inside the data folder, never to
  /// folders.
  void walk_folder(const fs::path& folder) {
    std::error_code failed;
    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
      if (!entry->path().filename().string().starts_with('.')) entries.push_back(entry->path());
    }
    if (failed)
      listing_.refused.push_back({folder, "the folder cannot be read: " + failed.message()});
    std::sort(entries.begin(), entries.end());
    for (const auto& entry : entries) visit(entry);
  }

  void visit(const fs::path& entry) {
    throw_if_cancelled(context_.stop);
    std::error_code failed;
    const bool link = fs::is_symlink(entry, failed);
    const auto contained = contained_path(entry, context_.root);
    if (!contained) {
      if (link)
        listing_.refused.push_back({entry, "the link leads out of the data folder, or nowhere"});
      return;
    }
    if (fs::is_directory(*contained, failed)) {
      if (!link) walk_folder(*contained);
      return;
    }
    if (fs::is_regular_file(*contained, failed) && seen_.insert(*contained).second)
      sort_file(*contained);
  }

  void sort_file(const fs::path& file) {
    if (printable(file.string()) != file.string()) {
      listing_.refused.push_back({file, "the file's name is not readable text; expected UTF-8"});
      return;
    }
    context_.announce(file);
    const FileKind kind = kind_of(file);
    std::error_code failed;
    if (kind != FileKind::none && fs::file_size(file, failed) == 0 && !failed) {
      listing_.refused.push_back({file, "the file is empty"});
      return;
    }
    if (context_.is_trial) return try_out(kind, file);
    if (kind == FileKind::dicom) dicom_.push_back(file);
    if (kind == FileKind::picture) pictures_.push_back(file);
    if (is_grid(kind)) add_grid(kind, file);
  }

  /// What has no name of a known format and was opened all the same was so for its mark.
  FileKind kind_of(const fs::path& file) const {
    const FileKind kind = kind_by_name(file);
    if (kind != FileKind::none) return kind;
    const bool marked = context_.given_up.contains(file) || looks_like_dicom(file);
    return marked ? FileKind::dicom : FileKind::none;
  }

  VolumeSource grid_source(FileKind kind, const fs::path& file) const {
    const auto open = kind == FileKind::nifti  ? open_nifti
                      : kind == FileKind::nrrd ? open_nrrd
                                               : open_metaimage;
    return source_of(open(file, context_.root, context_.limits), context_);
  }

  /// For the harm that it may do, which ends this process.
  void try_out(FileKind kind, const fs::path& file) const {
    if (kind == FileKind::none || context_.opened.contains(file)) return;
    try {
      context_.look_into(file, [&] {
        if (kind == FileKind::dicom) return !read_dicom_frames(file).empty();
        if (kind == FileKind::picture) return open_image_file(file).pages > 0;
        return !grid_source(kind, file).files.empty();
      });
    } catch (const Error&) {  // for the scan that lists it to say
    }
  }

  void add_dicom(const fs::path& path) {
    if (!context_.dicom_refused) {
      add(find_dicom(dicom_, context_));
    } else if (!dicom_.empty()) {
      listing_.refused.push_back({path, *context_.dicom_refused});
    }
  }

  void add_grid(FileKind kind, const fs::path& file) {
    try {
      listing_.volumes.push_back(context_.look_into(file, [&] { return grid_source(kind, file); }));
    } catch (const Error& error) {
      listing_.refused.push_back({file, reason_of(error)});
    }
  }

  void add(Listing found) {
    std::move(found.volumes.begin(), found.volumes.end(), std::back_inserter(listing_.volumes));
    std::move(found.refused.begin(), found.refused.end(), std::back_inserter(listing_.refused));
  }

  /// Pictures and a DICOM series in one folder would both go by its name.
  void make_ids_unique() {
    std::set<std::string> taken;
    for (auto& source : listing_.volumes) {
      std::string& id = source.description.id;
      const std::string base = id;
      for (int number = 2; !taken.insert(id).second; ++number)
        id = base + "~" + std::to_string(number);
    }
  }

  ScanContext context_;
  Listing listing_;
  std::set<fs::path> seen_;
  std::vector<fs::path> dicom_;
  std::vector<fs::path> pictures_;
};

}  // namespace

Listing scan_volumes(const fs::path& path, const fs::path& data_root, const ImportLimits& limits,
                     std::stop_token stop) {
  ScanContext context;
  context.limits = limits;
  context.stop = std::move(stop);
  return scan_in_context(path, data_root, std::move(context));
}

Listing reading::scan_in_context(const fs::path& path, const fs::path& data_root,
                                 ScanContext context) {
  std::error_code failed;
  const fs::path canonical = fs::canonical(path, failed);
  if (failed) refuse(path, "there is no such file or folder");
  context.root = fs::canonical(data_root, failed);
  if (failed) refuse(data_root, "there is no such folder");
  if (!contained_path(canonical, context.root)) {
    refuse(path, "the path leads out of the data folder");
  }
  return Walk(std::move(context)).run(canonical);
}

}  // namespace cutaway
