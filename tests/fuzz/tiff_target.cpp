// The chain of a TIFF's pages: a count within the limit, or a reason in words.
#include "core/check.h"
#include "core/error.h"
#include "fuzz/input_file.h"
#include "fuzz/planted_fault.h"
#include "import/pictures/tiff_pages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cutaway;
  constexpr int kMost = 100;
  static const fuzz::InputFile file("file.tif");
  file.write(data, size);
  try {
    const reading::TiffPages pages = reading::tiff_pages(file.path(), kMost);
    check(pages.count >= 0 && pages.count <= kMost + 1, "pages are counted up to the limit");
    fuzz::planted_fault(pages.first_that_differs == 1);
  } catch (const Error&) {
  }
  return 0;
}
