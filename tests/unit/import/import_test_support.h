// What the readers' tests share: folders that go away, files made by hand, and an object whose
// place in the patient shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "import/reader.h"

namespace cutaway::test {

/// A fresh folder; removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Creates the folders on the way.
void write_file(const std::filesystem::path& file, std::string_view bytes);
std::string read_file(const std::filesystem::path& file);

/// Numbers as bytes in either order.
template <typename T>
std::string bytes_of_numbers(const std::vector<T>& numbers, bool big_endian = false) {
  std::string bytes;
  for (const T number : numbers) {
    std::string raw(reinterpret_cast<const char*>(&number), sizeof(T));
    if (big_endian) raw.assign(raw.rbegin(), raw.rend());
    bytes += raw;
  }
  return bytes;
}

std::string gzip(std::string_view bytes);
std::string zlib(std::string_view bytes);
std::string bzip2(std::string_view bytes);

/// The only volume of a folder or file; fails the test where there is another number or anything
/// was refused.
VolumeSource only_source(const std::filesystem::path& path, const std::filesystem::path& root);
Volume read_only_volume(const std::filesystem::path& path);
Volume read(const VolumeSource& source);
Listing scan(const std::filesystem::path& path);

/// The reason for which the only file of a folder is refused; fails the test where it is not.
std::string only_refusal(const std::filesystem::path& path);

/// What reading throws, as text; empty where it succeeds.
std::string read_failure(const VolumeSource& source);

/// An object that looks different from every side: its value rises by another amount along each
/// axis of the patient.
double patient_ramp(glm::dvec3 position_patient_mm);

/// The ramp's values over a grid, i fastest: index (i,j,k) at origin + steps * (i,j,k).
std::vector<double> ramp_values(glm::ivec3 size, const glm::dmat3& steps_mm, glm::dvec3 origin_mm);

/// Each voxel of `volume` has the value that the ramp has at its place in the patient; voxels of
/// the value `uncovered` may be left out, but not more than that fraction of all.
void expect_ramp(const Volume& volume, double tolerance, double uncovered_fraction = 0.0);

bool has_warning(const VolumeDescription& description, std::string_view part);

}  // namespace cutaway::test
