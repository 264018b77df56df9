#include "import/scan.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/check.h"
#include "import/data_root.h"
#include "import/foreign_formats.h"
#include "import/format_table.h"
#include "import/natural_order.h"
#include "import/refusal.h"

namespace cutaway {

namespace fs = std::filesystem;
using namespace reading;

namespace {

class Walk {
 public:
  /// A file that is tried out alone is not grouped with others: what breaks there is its own.
  explicit Walk(ScanContext context) : context_(std::move(context)) {
    if (context_.is_trial) context_.on_grouping = nullptr;
  }

  Listing run(const fs::path& path) {
    path_ = path;
    if (fs::is_directory(path)) {
      walk_folder(path);
    } else {
      sort_file(path);
    }
    if (context_.is_trial) return {};
    for (const auto& [format, files] : files_by_format_) add(format->find(files, context_));
    sort_as_people_count();
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
    const Format* format = format_of(file);
    if (!format) return name_if_foreign(file);
    std::error_code failed;
    if (fs::file_size(file, failed) == 0 && !failed) {
      listing_.refused.push_back({file, "the file is empty"});
    } else if (context_.is_trial) {
      try_out(*format, file);
    } else {
      files_by_format_[format].push_back(file);
    }
  }

  /// What is no volume at all is passed over, unless it alone was asked for.
  void name_if_foreign(const fs::path& file) {
    if (context_.is_trial) return;
    const auto what = foreign_format_of(file);
    if (!what && file != path_) return;
    listing_.refused.push_back({file, (what ? *what + ": not one of the formats that are read"
                                            : "no volume of a known format") +
                                          "; expected " + formats_in_words()});
  }

  /// For the harm that it may do, which ends this process; what is found is for the scan that lists
  /// it.
  void try_out(const Format& format, const fs::path& file) const {
    if (!context_.opened.contains(file)) format.find(std::array{file}, context_);
  }

  void add(Listing found) {
    std::move(found.volumes.begin(), found.volumes.end(), std::back_inserter(listing_.volumes));
    std::move(found.refused.begin(), found.refused.end(), std::back_inserter(listing_.refused));
  }

  /// "2" before "10".
  void sort_as_people_count() {
    const NaturalOrder before;
    std::stable_sort(
        listing_.volumes.begin(), listing_.volumes.end(),
        [&](const auto& a, const auto& b) { return before(a.description.id, b.description.id); });
    std::stable_sort(
        listing_.refused.begin(), listing_.refused.end(),
        [&](const auto& a, const auto& b) { return before(a.path.string(), b.path.string()); });
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
  fs::path path_;
  Listing listing_;
  std::set<fs::path> seen_;
  std::map<const Format*, std::vector<fs::path>> files_by_format_;  ///< in the table's order
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
