#include "services/volume_catalogue.h"

#include <algorithm>
#include <utility>

#include "core/log.h"
#include "core/threads.h"
#include "scene/scene_json.h"
#include "services/client_words.h"
#include "services/first_volume.h"
#include "services/named_path.h"
#include "volume/phantoms.h"

#ifdef CUTAWAY_IMPORT
#include "import/isolation/isolated_reader.h"
#endif

namespace cutaway {

namespace fs = std::filesystem;

namespace {

CatalogueEntry phantom_entry(const PhantomRequest& request) {
  return {.description = describe_phantom(request),
          .geometry = phantom_geometry(request),
          .read = [request](const ProgressSink& progress, const std::stop_token& stop) {
            return make_phantom(request, progress, stop);
          }};
}

Json entry_json(const CatalogueEntry& entry) {
  const glm::ivec3 size = entry.geometry.size_voxels;
  return {{"id", entry.description.id},
          {"title", entry.description.title},
          {"format", entry.description.format},
          {"modality", entry.description.modality},
          {"size_voxels", {size.x, size.y, size.z}},
          {"spacing_mm", vector_json(entry.geometry.spacing_mm)},
          {"worth", worth_seeing(entry.description, entry.geometry)},
          {"warnings", entry.description.warnings}};
}

Error unknown(const std::string& id) {
  return Error({.code = ErrorCode::unknown_volume,
                .message = "there is no such volume",
                .field = "/volume",
                .expected = "an id of the volumes message",
                .received = id});
}

}  // namespace

VolumeCatalogue::VolumeCatalogue(const VolumeSettings& settings, std::function<void()> changed)
    : settings_(settings), changed_(std::move(changed)), folders_to_scan_(settings.data.size()) {
  for (const PhantomKind kind : {PhantomKind::head, PhantomKind::abdomen, PhantomKind::knees}) {
    phantoms_.push_back(phantom_entry({.kind = kind}));
  }
  scanner_ = start_thread([this](const std::stop_token& stop) { scan_all(stop); });
}

Json VolumeCatalogue::listing() const {
  const std::lock_guard lock(mutex_);
  Json volumes = Json::array();
  for (const CatalogueEntry& entry : files_) volumes.push_back(entry_json(entry));
  for (const CatalogueEntry& entry : phantoms_) volumes.push_back(entry_json(entry));
  return {
      {"volumes", std::move(volumes)}, {"refused", refused_}, {"scanning", folders_to_scan_ > 0}};
}

std::optional<CatalogueEntry> VolumeCatalogue::find(const std::string& id) const {
  if (const auto phantom = parse_phantom_id(id)) return phantom_entry(*phantom);
  const std::lock_guard lock(mutex_);
  std::optional<CatalogueEntry> entry = known(id);
  if (!entry && folders_to_scan_ == 0) throw unknown(id);
  return entry;
}

std::optional<CatalogueEntry> VolumeCatalogue::known(const std::string& id) const {
  const auto entry = std::ranges::find_if(
      files_, [&id](const CatalogueEntry& each) { return each.description.id == id; });
  if (entry == files_.end()) return std::nullopt;
  return *entry;
}

void VolumeCatalogue::scan_all(const std::stop_token& stop) {
  for (const fs::path& path : settings_.data) {
    try {
      scan(path, stop);
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception& failure) {
      log().warn("{} cannot be scanned: {}", path.string(), failure.what());
      const auto* error = dynamic_cast<const Error*>(&failure);
      refuse(path_for_client(path, path),
             error != nullptr ? error->detail().message : "it cannot be scanned");
    }
    {
      const std::lock_guard lock(mutex_);
      --folders_to_scan_;
    }
    changed_();
  }
}

#ifdef CUTAWAY_IMPORT
namespace {

Listing scan_path(const VolumeSettings& settings, const fs::path& path, const fs::path& root,
                  const std::stop_token& stop) {
  const ImportLimits limits{.volume_bytes = settings.volume_bytes};
  if (settings.reader.empty()) return scan_volumes(path, root, limits, stop);
  return scan_volumes_isolated({.executable = settings.reader}, path, root, limits, stop);
}

Volume read_source(const VolumeSettings& settings, const VolumeSource& source,
                   const ProgressSink& progress, std::stop_token stop) {
  const ImportLimits limits{.volume_bytes = settings.volume_bytes};
  if (settings.reader.empty()) return read_volume(source, limits, progress, std::move(stop));
  return read_volume_isolated({.executable = settings.reader}, source, limits, progress,
                              std::move(stop));
}

// The field stays whole: it is for the log.
Error in_words_for_client(const Error& error, const fs::path& root) {
  Error::Detail detail = error.detail();
  for (std::string* text : {&detail.message, &detail.expected, &detail.received}) {
    *text = text_for_client(std::move(*text), root);
  }
  return Error(detail);
}

CatalogueEntry file_entry(const VolumeSettings& settings, const VolumeSource& source,
                          const fs::path& root) {
  return {.description = source.description,
          .geometry = source.geometry,
          .read = [settings, source, root](const ProgressSink& progress, std::stop_token stop) {
            try {
              return read_source(settings, source, progress, std::move(stop));
            } catch (const Error& error) {
              throw in_words_for_client(error, root);
            }
          }};
}

}  // namespace

void VolumeCatalogue::scan(const fs::path& given, const std::stop_token& stop) {
  const auto [path, root] = named_path(given);
  const Listing listing = scan_path(settings_, path, root, stop);
  for (const VolumeSource& source : listing.volumes) add(file_entry(settings_, source, root));
  for (const RefusedFile& file : listing.refused) {
    refuse(path_for_client(file.path, root), text_for_client(file.reason, root));
  }
  log().info("{}: {} volumes, {} refused", given.string(), listing.volumes.size(),
             listing.refused.size());
}
#else
void VolumeCatalogue::scan(const fs::path& path, const std::stop_token&) {
  refuse(path_for_client(path, path), "this build reads no files, only phantoms");
}
#endif

// Two folders may hold volumes of the same name; the later one is told apart by a number.
void VolumeCatalogue::add(CatalogueEntry entry) {
  const std::lock_guard lock(mutex_);
  const std::string id = entry.description.id;
  for (int i = 2; known(entry.description.id); ++i) {
    entry.description.id = id + "~" + std::to_string(i);
  }
  files_.push_back(std::move(entry));
}

void VolumeCatalogue::refuse(std::string path, std::string reason) {
  const std::lock_guard lock(mutex_);
  refused_.push_back({{"path", std::move(path)}, {"reason", std::move(reason)}});
}

}  // namespace cutaway
