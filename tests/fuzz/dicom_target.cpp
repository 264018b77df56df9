// The elements of a DICOM file, as they are walked before GDCM sees them: whole, or a reason in
// words. What GDCM itself makes of broken headers stays in its own process (import/isolation).
#include <string_view>

#include "core/error.h"
#include "fuzz/input_file.h"
#include "fuzz/planted_fault.h"
#include "import/dicom/elements.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cutaway;
  // More elements than it began with, and still whole.
  constexpr std::size_t kSeedBytes = CUTAWAY_FUZZ_SEED_BYTES;
  static const fuzz::InputFile file("file.dcm");
  file.write(data, size);
  try {
    reading::require_whole_elements(file.path());
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    fuzz::planted_fault(size > kSeedBytes + 8 && bytes.substr(128, 4) == "DICM");
  } catch (const Error&) {
  }
  return 0;
}
