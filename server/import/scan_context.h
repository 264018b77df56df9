// What a scan is told before it begins, and whom it tells what it is at.
#pragma once

#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/error.h"
#include "import/reader.h"

namespace cutaway::reading {

/// A scan that goes on after another that broke off knows how far that one came.
struct ScanContext {
  std::filesystem::path root;  ///< canonical
  ImportLimits limits;
  std::stop_token stop;

  std::map<std::filesystem::path, std::string>
      given_up;                              ///< not even to be opened, with the reason to say
  std::set<std::filesystem::path> opened;    ///< by an earlier scan, without harm
  bool only_opened = false;                  ///< what else there is is refused unopened
  bool is_trial = false;                     ///< opens what no scan has opened, and lists nothing
  std::optional<std::string> dicom_refused;  ///< why no DICOM series are looked for

  std::function<void(const std::filesystem::path& file)> on_file;    ///< before each is opened
  std::function<void(const std::filesystem::path& file)> on_opened;  ///< where it did no harm
  std::function<void()> on_grouping;  ///< when all DICOM headers are read and no file is at work

  /// Throws Cancelled when stopped.
  void announce(const std::filesystem::path& file) const;

  /// What `open` finds in the file, said before and after. Throws Error where the file is not to be
  /// opened, or `open` throws.
  template <typename Open>
  auto look_into(const std::filesystem::path& file, const Open& open) const {
    require_openable(file);
    announce(file);
    try {
      auto found = open();
      if (on_opened) on_opened(file);
      return found;
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& failure) {
      if (on_opened) on_opened(file);
      rethrow_as_error(file, failure);
    }
  }

 private:
  void require_openable(const std::filesystem::path& file) const;
  [[noreturn]] static void rethrow_as_error(const std::filesystem::path& file,
                                            const std::exception& failure);
};

}  // namespace cutaway::reading
