// volume.json beside pictures: fields that are usable, or a reason in words.
#include <cmath>

#include "core/check.h"
#include "core/error.h"
#include "fuzz/input_file.h"
#include "fuzz/json_mutator.h"
#include "fuzz/planted_fault.h"
#include "import/pictures/sidecar.h"

namespace {

using namespace cutaway;

void judge(const reading::Sidecar& sidecar) {
  check(std::isfinite(sidecar.slope) && sidecar.slope != 0.0, "a slope is usable");
  if (!sidecar.spacing_mm) return;
  const glm::dvec3 spacing = *sidecar.spacing_mm;
  check(spacing.x > 0.0 && spacing.y > 0.0 && spacing.z > 0.0, "a spacing is usable");
  fuzz::planted_fault(spacing.z > 50.0);
}

}  // namespace

void cutaway::fuzz::change(Json& document, Generator& generator) {
  change_anywhere(document, generator);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file(reading::kSidecarName);
  file.write(data, size);
  try {
    judge(reading::read_sidecar(file.path()));
  } catch (const Error&) {
  }
  return 0;
}
