// Files of each format with bytes changed, cut and doubled: whatever comes, it is a volume or an
// Error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"
#include "import/isolated_reader.h"
#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"
#include "unit/import/nifti_writer.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

/// GDCM ends its process at some broken headers, so those files are only ever opened by a child.
struct Sample {
  const char* name;
  bool isolated;
  int rounds;
  std::function<void(const fs::path& folder)> write;
};

void write_dicom_pair(const fs::path& folder, bool compressed) {
  for (int k = 0; k < 2; ++k) {
    DicomSlice slice;
    slice.size_px = {8, 8};
    slice.position_mm = {0, 0, 2.0 * k};
    slice.fill_with_ramp();
    const fs::path file = folder / (k == 0 ? "a.dcm" : "b.dcm");
    write_dicom(file, slice);
    if (compressed) transcode(file, k == 0 ? Syntax::jpeg_ls : Syntax::rle);
  }
}

void write_enhanced(const fs::path& folder) {
  std::vector<DicomSlice> frames(3);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    frames[k].position_mm = {0, 0, 3.0 * static_cast<double>(k)};
    frames[k].fill_with_ramp();
  }
  write_enhanced_dicom(folder / "e.dcm", frames);
}

std::string nifti_bytes() {
  const NiftiFile nifti{.dim = {4, 4, 4}, .datatype = 4};
  return nifti.with(std::string(128, 'v'));
}

std::string nrrd_header(const std::string& encoding) {
  return "NRRD0004\ntype: short\ndimension: 3\nspace: RAS\nsizes: 4 4 4\nspace directions: "
         "(1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nspace units: \"cm\" \"cm\" \"cm\"\n"
         "kinds: domain domain domain\nendian: little\nencoding: " +
         encoding + "\n\n";
}

/// Two pictures, of which the first is changed.
void write_pictures(const fs::path& folder, const std::string& ending, const std::string& bytes) {
  write_file(folder / ("a" + ending), bytes);
  write_file(folder / ("b" + ending), bytes);
}

std::string tiff_of(std::uint16_t compression, std::uint32_t pages = 1) {
  const std::string pixels(128, 'v');
  return tiff_bytes({.size_px = {8, 8},
                     .pixels = compression == 8 ? zlib(pixels) : pixels,
                     .compression = compression,
                     .pages = pages});
}

std::string png_of(std::uint8_t colour_type, std::size_t row_bytes) {
  return png_bytes({.size_px = {8, 8},
                    .colour_type = colour_type,
                    .pixels = std::string(8 * row_bytes, 'v'),
                    .row_bytes = row_bytes});
}

const Sample kSamples[]{
    {"dicom", true, 10, [](const fs::path& folder) { write_dicom_pair(folder, false); }},
    {"dicom_compressed", true, 10, [](const fs::path& folder) { write_dicom_pair(folder, true); }},
    {"dicom_enhanced", true, 10, write_enhanced},
    {"nifti", false, 400,
     [](const fs::path& folder) { write_file(folder / "a.nii", nifti_bytes()); }},
    {"nifti_gz", false, 400,
     [](const fs::path& folder) { write_file(folder / "a.nii.gz", gzip(nifti_bytes())); }},
    {"nrrd", false, 400,
     [](const fs::path& folder) {
       write_file(folder / "a.nrrd", nrrd_header("gzip") + gzip(std::string(128, 'v')));
     }},
    {"nrrd_bzip2", false, 400,
     [](const fs::path& folder) {
       write_file(folder / "a.nrrd", nrrd_header("bzip2") + bzip2(std::string(128, 'v')));
     }},
    {"tiff", false, 200,
     [](const fs::path& folder) { write_pictures(folder, ".tif", tiff_of(1)); }},
    {"tiff_zip", false, 200,
     [](const fs::path& folder) { write_pictures(folder, ".tif", tiff_of(8)); }},
    {"tiff_pages", false, 200,
     [](const fs::path& folder) { write_file(folder / "a.tif", tiff_of(1, 4)); }},
    {"png", false, 200,
     [](const fs::path& folder) { write_pictures(folder, ".png", png_of(0, 8)); }},
    {"png_rgba", false, 200,
     [](const fs::path& folder) { write_pictures(folder, ".png", png_of(6, 32)); }},
    {"metaimage", false, 400,
     [](const fs::path& folder) {
       write_file(folder / "a.mha",
                  "NDims = 3\nDimSize = 4 4 4\nElementSpacing = 1 1 1\nOffset = 0 0 0\nElementType "
                  "= MET_SHORT\n"
                  "CompressedData = True\nElementDataFile = LOCAL\n" +
                      zlib(std::string(128, 'v')));
     }},
    {"sidecar", false, 400, [](const fs::path& folder) {
       write_file(folder / "volume.json",
                  R"({"spacing_mm": [1, 1, 2], "rescale": {"slope": 1}, "units": "HU"})");
       write_file(folder / "a.tif", "II*");
     }}};

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

std::string corrupted(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t limit) { return random() % limit; };
  const std::size_t kind = below(8);
  if (kind == 0) return bytes.substr(0, below(bytes.size()));
  if (kind == 1) return bytes.insert(below(bytes.size()), bytes.substr(0, below(bytes.size())));
  if (kind == 2) return bytes.erase(below(bytes.size()), 1 + below(16));
  if (kind == 3) {
    const std::size_t begin = below(bytes.size());
    const std::size_t zeros = std::min(bytes.size() - begin, 1 + below(32));
    return bytes.replace(begin, zeros, zeros, '\0');
  }
  for (std::size_t i = 0; i < 1 + below(4); ++i)
    bytes[below(bytes.size())] = static_cast<char>(random());
  return bytes;
}

class Corruption : public testing::TestWithParam<Sample> {
 protected:
  Listing scan(const fs::path& folder) const {
    return GetParam().isolated ? scan_volumes_isolated(worker_, folder, folder, limits_, {})
                               : scan_volumes(folder, folder, limits_, {});
  }

  Volume read(const VolumeSource& source) const {
    return GetParam().isolated ? read_volume_isolated(worker_, source, limits_, {}, {})
                               : read_volume(source, limits_, {}, {});
  }

 private:
  IsolatedReader worker_{.executable = CUTAWAY_TEST_WORKER};
  ImportLimits limits_{.volume_bytes = 1 << 20};
};

TEST_P(Corruption, GivesAVolumeOrAnError) {
  TemporaryFolder folder;
  GetParam().write(folder.path());
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  const std::string original = read_file(files.front());
  std::mt19937 random(20240607);
  for (int round = 0; round < GetParam().rounds; ++round) {
    SCOPED_TRACE(round);
    write_file(files.front(), corrupted(original, random));
    for (const auto& source : scan(folder.path()).volumes) {
      try {
        const Volume volume = read(source);
        ASSERT_EQ(volume.geometry, source.geometry);
        ASSERT_TRUE(std::isfinite(volume.value_range.minimum));
        ASSERT_TRUE(std::isfinite(volume.value_range.maximum));
      } catch (const Error& error) {
        ASSERT_FALSE(error.detail().field.empty());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Corruption, testing::ValuesIn(kSamples),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cutaway::test
