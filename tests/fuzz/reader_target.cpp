// A file with the ending CUTAWAY_FUZZ_ENDING, through the readers' own door: volumes that make
// sense, or reasons in words.
#include <cmath>

#include "core/check.h"
#include "core/error.h"
#include "fuzz/input_file.h"
#include "fuzz/planted_fault.h"
#include "import/reader.h"

namespace {

using namespace cutaway;
constexpr ImportLimits kLimits{.volume_bytes = 1 << 20};

void judge(const VolumeSource& source) {
  const glm::dvec3 spacing = source.geometry.spacing_mm;
  for (int axis = 0; axis < 3; ++axis) {
    check(std::isfinite(spacing[axis]) && spacing[axis] > 0.0, "a listed volume has a spacing");
  }
  fuzz::planted_fault(spacing.z > 50.0);
  try {
    (void)read_volume(source, kLimits, {}, {});
  } catch (const Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("file" CUTAWAY_FUZZ_ENDING);
  file.write(data, size);
  const Listing listing = scan_volumes(file.path(), file.folder(), kLimits, {});
  for (const RefusedFile& refused : listing.refused) {
    check(!refused.reason.empty(), "a refusal has a reason");
  }
  for (const VolumeSource& source : listing.volumes) judge(source);
  return 0;
}
