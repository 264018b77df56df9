// What can be opened: phantoms at once, files as a scan finds them.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/progress.h"
#include "scene/json.h"
#include "services/settings.h"
#include "volume/volume.h"

namespace cutaway {

struct CatalogueEntry {
  VolumeDescription description;
  VolumeGeometry geometry;  ///< as far as the header tells
  std::function<Volume(const ProgressSink&, std::stop_token)> read;
};

/// Thread-safe. Folders are scanned one after the other on a thread of its own.
class VolumeCatalogue {
 public:
  /// `changed` is called from the scanning thread after each folder; it throws nothing.
  VolumeCatalogue(const VolumeSettings& settings, std::function<void()> changed);

  /// As protocol/schema/volumes.schema.json has it: files in the order of their folders, then the
  /// phantoms.
  Json listing() const;
  /// Any phantom id is found, listed or not. Nothing while the scan may still find it; throws Error
  /// for an unknown id.
  std::optional<CatalogueEntry> find(const std::string& id) const;

 private:
  std::optional<CatalogueEntry> known(const std::string& id) const;
  void scan_all(const std::stop_token& stop);
  void scan(const std::filesystem::path& path, const std::stop_token& stop);
  void add(CatalogueEntry entry);
  void refuse(std::string path, std::string reason);

  VolumeSettings settings_;
  std::function<void()> changed_;
  mutable std::mutex mutex_;
  std::vector<CatalogueEntry> files_;
  std::vector<CatalogueEntry> phantoms_;
  Json refused_ = Json::array();
  std::size_t folders_to_scan_;
  std::jthread scanner_;  ///< last: it uses all the others
};

}  // namespace cutaway
