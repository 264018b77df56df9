// Files of each format with bytes changed, cut and doubled: whatever comes, it is a volume or an
// Error.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"
#include "import/reader.h"
#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"
#include "unit/import/nifti_writer.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

/// GDCM's codecs may end their process at broken pictures, or turn for ever, so those files are
/// only ever opened by a child: one that is forked, since to start a program takes a second. That a
/// child's end is survived, and said, is for the tests of the isolated reader.
struct Sample {
  const char* name;
  bool forked;
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

void write_odd_pair(const fs::path& folder, const std::function<void(DicomSlice&)>& change,
                    const std::function<void(const fs::path&)>& rewrite) {
  for (int k = 0; k < 2; ++k) {
    DicomSlice slice;
    slice.position_mm = {0, 0, 2.0 * k};
    slice.fill_with_ramp();
    change(slice);
    const fs::path file = folder / (k == 0 ? "a.dcm" : "b.dcm");
    write_dicom(file, slice);
    if (rewrite) rewrite(file);
  }
}

void give_table(DicomSlice& slice) {
  slice.table = {.first_stored = 1000, .entries = {4, 3, 2, 1}, .type = "US"};
  slice.texts[{0x0008, 0x0005}] = "\\ISO 2022 IR 87";
  slice.texts[{0x0008, 0x103e}] = "\x1B$BF,It\x1B(B";
}

void give_floats(DicomSlice& slice) { slice.floats.assign(16, 1.5F); }

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
    {"dicom", true, 80, [](const fs::path& folder) { write_dicom_pair(folder, false); }},
    {"dicom_compressed", true, 80, [](const fs::path& folder) { write_dicom_pair(folder, true); }},
    {"dicom_enhanced", true, 80, write_enhanced},
    {"dicom_table", true, 80,
     [](const fs::path& folder) { write_odd_pair(folder, give_table, {}); }},
    {"dicom_float", true, 80,
     [](const fs::path& folder) { write_odd_pair(folder, give_floats, {}); }},
    {"dicom_bare", true, 80,
     [](const fs::path& folder) { write_odd_pair(folder, give_table, strip_file_header); }},
    {"dicom_deflated", true, 80,
     [](const fs::path& folder) {
       write_odd_pair(
           folder, [](DicomSlice&) {},
           [](const fs::path& file) { transcode(file, Syntax::deflated); });
     }},
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

constexpr ImportLimits kLimits{.volume_bytes = 1 << 20};

/// What is wrong with a refusal, or nothing: it has words, and they name what is refused.
std::string fault_of(const std::string& message, const std::string& field) {
  if (message.empty()) return "a refusal says nothing";
  return field.empty() ? "a refusal names nothing: " + message : "";
}

std::string fault_of_reading(const VolumeSource& source) {
  try {
    const Volume volume = read_volume(source, kLimits, {}, {});
    if (volume.geometry != source.geometry) return "another grid was read than was listed";
    const ValueRange range = volume.value_range;
    const bool finite = std::isfinite(range.minimum) && std::isfinite(range.maximum);
    return finite ? "" : "the values are not finite";
  } catch (const Error& error) {
    return fault_of(error.detail().message, error.detail().field);
  }
}

std::string fault_of_folder(const fs::path& folder) {
  const Listing listing = scan_volumes(folder, folder, kLimits, {});
  for (const auto& [path, reason] : listing.refused) {
    if (std::string fault = fault_of(reason, path.string()); !fault.empty()) return fault;
  }
  for (const auto& source : listing.volumes) {
    if (std::string fault = fault_of_reading(source); !fault.empty()) return fault;
  }
  return "";
}

/// Rounds of one sample: each changes the first of its files in its own way.
class Rounds {
 public:
  explicit Rounds(const Sample& sample) : sample_(sample) {
    sample.write(folder_.path());
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_.path())) files.push_back(entry.path());
    changed_ = *std::min_element(files.begin(), files.end());
    original_ = read_file(changed_);
  }

  std::string fault_of_round(int round) const {
    std::mt19937 random(20240607 + static_cast<unsigned>(round));
    write_file(changed_, corrupted(original_, random));
    const std::string fault = fault_of_folder(folder_.path());
    return fault.empty() ? "" : fmt::format("round {}: {}", round, fault);
  }

  std::string first_fault_from(int round) const {
    std::string fault;
    for (; round < sample_.rounds && fault.empty(); ++round) fault = fault_of_round(round);
    return fault;
  }

  /// Of all rounds, done by children; where one comes to a sudden end, the next goes on behind that
  /// round.
  std::string first_fault_in_children() const {
    const fs::path progress = outside_ / "round.txt";
    const fs::path answer = outside_ / "fault.txt";
    for (int round = 0; !fs::exists(answer); round = std::stoi(read_file(progress)) + 1) {
      write_file(progress, std::to_string(sample_.rounds));
      const pid_t child = fork();
      if (child == 0) run_child(round, progress, answer);
      waitpid(child, nullptr, 0);
    }
    return read_file(answer);
  }

 private:
  static void end_after_processor_time() {
    const itimerval half_a_second{.it_interval = {}, .it_value = {.tv_sec = 0, .tv_usec = 500'000}};
    setitimer(ITIMER_PROF, &half_a_second, nullptr);
  }

  [[noreturn]] void run_child(int round, const fs::path& progress, const fs::path& answer) const {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    std::string fault;
    for (; round < sample_.rounds && fault.empty(); ++round) {
      write_file(progress, std::to_string(round));
      end_after_processor_time();
      fault = fault_of_round(round);
    }
    write_file(answer, fault);
    _exit(0);  // threads of libraries have not come along to be ended
  }

  const Sample& sample_;
  TemporaryFolder folder_;
  TemporaryFolder outside_;
  fs::path changed_;
  std::string original_;
};

class Corruption : public testing::TestWithParam<Sample> {};

TEST_P(Corruption, GivesAVolumeOrAnError) {
  const Rounds rounds(GetParam());
  EXPECT_EQ(GetParam().forked ? rounds.first_fault_in_children() : rounds.first_fault_from(0), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, Corruption, testing::ValuesIn(kSamples),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cutaway::test
