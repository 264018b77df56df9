// What the tests of the child process share. Only for programs that know CUTAWAY_TEST_WORKER.
#pragma once

#include "import/isolation/isolated_reader.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {

inline IsolatedReader worker(const std::string& mode = "read-volume-worker") {
  return {.executable = CUTAWAY_TEST_WORKER, .arguments = {mode}, .memory_bytes = 0};
}

/// A MetaImage of 16 x 16 x 16 rising numbers.
inline std::filesystem::path write_ramp_volume(const TemporaryFolder& folder) {
  std::vector<std::int16_t> voxels(4096);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::int16_t>(i);
  std::filesystem::path file = folder / "ramp.mha";
  write_file(file,
             "NDims = 3\nDimSize = 16 16 16\nElementSpacing = 1 2 3\nOffset = 4 5 6\n"
             "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
                 bytes_of_numbers(voxels));
  return file;
}

}  // namespace cutaway::test
