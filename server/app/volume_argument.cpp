#include "app/volume_argument.h"

#include "volume/phantoms.h"

#ifdef CUTAWAY_IMPORT
#include "import/isolation/isolated_reader.h"
#include "services/named_path.h"
#endif

namespace cutaway {

namespace {

#ifdef CUTAWAY_IMPORT
std::string ids_of(const Listing& listing) {
  std::string ids;
  for (const VolumeSource& source : listing.volumes)
    ids += (ids.empty() ? "" : ", ") + source.description.id;
  return ids;
}

[[noreturn]] void refuse(const std::string& path, const Listing& listing) {
  if (listing.volumes.empty() && !listing.refused.empty()) {
    const RefusedFile& first = listing.refused.front();
    throw Error(
        {.code = ErrorCode::volume_refused, .message = first.reason, .field = first.path.string()});
  }
  throw Error({.code = ErrorCode::unknown_volume,
               .message = "no single volume is named",
               .field = path,
               .expected = listing.volumes.empty()
                               ? "a volume there"
                               : "PATH#ID with one of the ids " + ids_of(listing),
               .received = std::to_string(listing.volumes.size()) + " volumes"});
}

struct Wanted {
  std::string path;
  std::string id;  ///< empty: the only volume there
};

/// A name may hold '#' itself.
Wanted split(const std::string& argument) {
  std::error_code failed;
  const auto hash = argument.rfind('#');
  if (hash == std::string::npos || std::filesystem::exists(argument, failed)) return {argument, ""};
  return {argument.substr(0, hash), argument.substr(hash + 1)};
}

Volume read_path(const std::string& argument, const ProgressSink& progress) {
  const auto [path, wanted] = split(argument);
  const NamedPath named = named_path(path);
  const Listing listing = scan_volumes_isolated({}, named.path, named.root, {}, {});
  for (const VolumeSource& source : listing.volumes) {
    const bool only_one = wanted.empty() && listing.volumes.size() == 1;
    if (only_one || source.description.id == wanted)
      return read_volume_isolated({}, source, {}, progress, {});
  }
  refuse(argument, listing);
}
#else
Volume read_path(const std::string& argument, const ProgressSink&) {
  throw Error({.code = ErrorCode::unknown_volume,
               .message = "this build reads no files",
               .field = argument,
               .expected = "a phantom: phantom:head, phantom:abdomen or phantom:knees"});
}
#endif

}  // namespace

std::shared_ptr<const LoadedVolume> load_volume_argument(const std::string& argument,
                                                         const ProgressSink& progress) {
  const auto phantom = parse_phantom_id(argument);
  return derive_loaded_volume(
      phantom ? make_phantom(*phantom, progress, {}) : read_path(argument, progress), progress, {});
}

}  // namespace cutaway
