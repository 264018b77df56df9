// A DICOM file: its elements, and what a scan makes of them, or a reason in words. What the
// decoders of others make of broken pixels stays in a process of its own (import/isolation).
#include "core/check.h"
#include "core/error.h"
#include "fuzz/input_file.h"
#include "fuzz/planted_fault.h"
#include "import/dicom/header.h"
#include "import/reader.h"

namespace {

using namespace cutaway;

constexpr std::size_t kSeedElements = 5;  // beside its pixels; see seeds.py

void judge(const std::filesystem::path& file) {
  reading::ByteSource source(file);
  const reading::DicomHeader header = reading::read_dicom_header(source);
  fuzz::planted_fault(header.data.elements.size() > kSeedElements && header.pixels.has_value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("file.dcm");
  file.write(data, size);
  try {
    judge(file.path());
  } catch (const Error&) {
  }
  const Listing listing = scan_volumes(file.path(), file.folder(), {.volume_bytes = 1 << 20}, {});
  for (const RefusedFile& refused : listing.refused) {
    check(!refused.reason.empty(), "a refusal has a reason");
  }
  return 0;
}
