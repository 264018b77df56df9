#include "unit/import/import_test_support.h"

#include <bzlib.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <fstream>
#include <sstream>

#include "core/error.h"

#ifdef __SANITIZE_ADDRESS__
/// GDCM's and OpenImageIO's own leaks when a file breaks off; none of ours goes through them.
extern "C" const char* __lsan_default_suppressions();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:gdcm::\nleak:libOpenImageIO\n";
}
#endif

namespace cutaway::test {

namespace fs = std::filesystem;

namespace {

constexpr int kZlib = 15;
constexpr int kGzip = 15 + 16;

std::string deflated(std::string_view bytes, int window_bits) {
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  std::string result(deflateBound(&stream, bytes.size()) + 64, '\0');
  std::string input(bytes);
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "cutaway-import-XXXXXX").string();
  path_ = fs::canonical(mkdtemp(name.data()));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code failed;
  fs::remove_all(path_, failed);
}

void write_file(const fs::path& file, std::string_view bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string read_file(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::string gzip(std::string_view bytes) { return deflated(bytes, kGzip); }
std::string zlib(std::string_view bytes) { return deflated(bytes, kZlib); }

std::string bzip2(std::string_view bytes) {
  std::string input(bytes);
  std::string result(bytes.size() + bytes.size() / 100 + 600, '\0');  // as bzip2's manual bounds it
  auto length = static_cast<unsigned>(result.size());
  BZ2_bzBuffToBuffCompress(result.data(), &length, input.data(),
                           static_cast<unsigned>(input.size()), 9, 0, 0);
  result.resize(length);
  return result;
}

Listing scan(const fs::path& path) {
  return scan_volumes(path, fs::is_directory(path) ? path : path.parent_path(), {}, {});
}

VolumeSource only_source(const fs::path& path, const fs::path& root) {
  const Listing listing = scan_volumes(path, root, {}, {});
  for (const auto& refused : listing.refused)
    ADD_FAILURE() << refused.path << ": " << refused.reason;
  EXPECT_EQ(listing.volumes.size(), 1U);
  if (listing.volumes.size() != 1) throw std::runtime_error("not one volume");
  return listing.volumes.front();
}

Volume read(const VolumeSource& source) { return read_volume(source, {}, {}, {}); }

Volume read_only_volume(const fs::path& path) {
  return read(only_source(path, fs::is_directory(path) ? path : path.parent_path()));
}

std::string only_refusal(const fs::path& path) {
  const Listing listing = scan(path);
  EXPECT_TRUE(listing.volumes.empty());
  EXPECT_EQ(listing.refused.size(), 1U);
  return listing.refused.empty() ? "" : listing.refused.front().reason;
}

std::string read_failure(const VolumeSource& source) {
  try {
    read(source);
  } catch (const Error& error) {
    EXPECT_FALSE(error.detail().field.empty());
    return error.what();
  }
  return "";
}

double patient_ramp(glm::dvec3 position_patient_mm) {
  return glm::dot(position_patient_mm, glm::dvec3(2.0, 3.0, 5.0)) + 1000.0;
}

std::vector<double> ramp_values(glm::ivec3 size, const glm::dmat3& steps_mm, glm::dvec3 origin_mm) {
  std::vector<double> values;
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) {
        values.push_back(patient_ramp(origin_mm + steps_mm * glm::dvec3(i, j, k)));
      }
    }
  }
  return values;
}

void expect_ramp(const Volume& volume, double tolerance, double uncovered_fraction) {
  const glm::dmat4 to_patient = index_to_patient(volume.geometry);
  const glm::ivec3 size = volume.geometry.size_voxels;
  int uncovered = 0;
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) {
        const double value = value_at(volume, {i, j, k});
        const double expected = patient_ramp(glm::dvec3(to_patient * glm::dvec4(i, j, k, 1)));
        if (std::abs(value - expected) <= tolerance) continue;
        const bool may_be_uncovered = std::abs(value - volume.value_range.minimum) <= tolerance;
        ASSERT_TRUE(uncovered_fraction > 0 && may_be_uncovered)
            << "at " << i << "," << j << "," << k << ": " << value << ", expected " << expected;
        ++uncovered;
      }
    }
  }
  EXPECT_LE(uncovered, uncovered_fraction * size.x * size.y * size.z);
}

bool has_warning(const VolumeDescription& description, std::string_view part) {
  for (const auto& warning : description.warnings) {
    if (warning.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace cutaway::test
