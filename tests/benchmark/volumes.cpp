#include "benchmark/volumes.h"

#include "core/error.h"
#include "volume/phantoms.h"

#ifdef CUTAWAY_IMPORT
#include "import/reader.h"
#endif

namespace cutaway::benchmark {

namespace {

NamedVolume phantom(PhantomKind kind, int size_voxels) {
  const PhantomRequest request{kind, size_voxels};
  return {phantom_id(request),
          [request] { return derive_loaded_volume(make_phantom(request, {}, {}), {}, {}); }};
}

#ifdef CUTAWAY_IMPORT
// In this process: what a benchmark is given to measure is trusted.
void add_cts_of(const std::filesystem::path& folder, std::vector<NamedVolume>& volumes) {
  for (const VolumeSource& source : scan_volumes(folder, folder, {}, {}).volumes) {
    if (source.description.modality != "CT") continue;
    volumes.push_back({source.description.id, [source] {
                         return derive_loaded_volume(read_volume(source, {}, {}, {}), {}, {});
                       }});
  }
}
#else
void add_cts_of(const std::filesystem::path& folder, std::vector<NamedVolume>&) {
  throw Error({.code = ErrorCode::unknown_volume,
               .message = "this build reads no files",
               .field = folder.string(),
               .expected = "no --data"});
}
#endif

}  // namespace

std::vector<NamedVolume> volumes_to_measure(const std::vector<int>& phantom_sizes_voxels,
                                            const std::optional<std::filesystem::path>& data) {
  std::vector<NamedVolume> volumes;
  for (const PhantomKind kind : {PhantomKind::head, PhantomKind::abdomen, PhantomKind::knees}) {
    for (const int size_voxels : phantom_sizes_voxels)
      volumes.push_back(phantom(kind, size_voxels));
  }
  if (data) add_cts_of(*data, volumes);
  return volumes;
}

}  // namespace cutaway::benchmark
