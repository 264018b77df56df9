#include "import/scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/info_command.h"
#include "core/error.h"
#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"
#include "unit/import/nifti_writer.h"
#include "unit/import/nrrd_writer.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

std::string small_metaimage() {
  return "NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 2 3\nOffset = 0 0 -5\nTransformMatrix = 0 "
         "1 0 1 0 0 0 0 -1\n"
         "ElementType = MET_UCHAR\nElementDataFile = LOCAL\nabcdefghijklmnopqrstuvwx";
}

TEST(Scan, ListsWhatIsGoodAndWhatIsBrokenAndPassesOverTheRest) {
  TemporaryFolder folder;
  write_file(folder / "one/good.mha", small_metaimage());
  write_file(folder / "two/deep/er/good.mha", small_metaimage());
  write_file(folder / "two/broken.nii", "no header");
  write_file(folder / "two/empty.nrrd", "");
  write_file(folder / "two/notes.txt", "hello");
  write_file(folder / "two/archive.tar.gz", "hello");
  write_file(folder / ".hidden/good.mha", small_metaimage());
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 2U);
  EXPECT_EQ(listing.volumes[0].description.id, "one/good.mha");
  EXPECT_EQ(listing.volumes[1].description.id, "two/deep/er/good.mha");
  ASSERT_EQ(listing.refused.size(), 2U);
  EXPECT_EQ(listing.refused[0].path, folder / "two/broken.nii");
  EXPECT_EQ(listing.refused[1].reason, "the file is empty");
}

TEST(Scan, IdsAreSafeInAddressesAndApart) {
  TemporaryFolder folder;
  for (const char* name : {"my scan.mha", "my-scan.mha", "my?scan.mha", "M\xC3\xBCller.mha"}) {
    write_file(folder / name, small_metaimage());
  }
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 4U);
  std::set<std::string> ids;
  for (const auto& source : listing.volumes) {
    const std::string& id = source.description.id;
    ids.insert(id);
    for (const char c : id) EXPECT_TRUE(std::isalnum(c) || std::strchr("._-/~", c)) << id;
  }
  EXPECT_EQ(ids.size(), 4U);
  const Listing again = scan(folder.path());
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(again.volumes[i].description.id, listing.volumes[i].description.id);
}

TEST(Scan, ListsTwoBeforeTen) {
  TemporaryFolder folder;
  for (const char* name : {"scan 2.mha", "scan 10.mha"})
    write_file(folder / name, small_metaimage());
  for (const char* name : {"broken 2.nii", "broken 10.nii"}) write_file(folder / name, "no header");
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 2U);
  EXPECT_EQ(listing.volumes[0].description.title, "scan 2");
  ASSERT_EQ(listing.refused.size(), 2U);
  EXPECT_EQ(listing.refused[0].path, folder / "broken 2.nii");
}

TEST(Scan, AMarkIsEnoughWhereTheNameSaysNothing) {
  TemporaryFolder folder;
  write_file(folder / "one/brain", NiftiFile().with(NiftiFile().ramp_voxels()));
  write_file(folder / "two/brain.bak",
             nrrd::header("LPS", {1, 1, 1}, "raw") + "\n" + nrrd::ramp_bytes());
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.refused.empty());
  ASSERT_EQ(listing.volumes.size(), 2U);
  EXPECT_EQ(listing.volumes[0].description.format, "NIfTI");
  EXPECT_EQ(listing.volumes[1].description.format, "NRRD");
  for (const auto& source : listing.volumes) expect_ramp(read(source), 0.5);
}

TEST(Scan, NamesFilesOfFormatsThatItDoesNotRead) {
  for (const auto& [name, bytes, what] :
       std::vector<std::array<std::string, 3>>{{"brain.mgz", "x", "FreeSurfer"},
                                               {"t1.mnc", "x", "MINC"},
                                               {"anat+orig.HEAD", "x", "AFNI"},
                                               {"grid.vti", "x", "VTK"},
                                               {"grid", "# vtk DataFile Version 3.0\n", "VTK"},
                                               {"scan.PAR", "x", "Philips"},
                                               {"data.h5", "x", "HDF5"},
                                               {"data", "\x89HDF\r\n\x1a\n", "HDF5"},
                                               {"a.npy", "x", "NumPy"},
                                               {"map", std::string(208, 'x') + "MAP ", "MRC"},
                                               {"cell.czi", "x", "microscope"},
                                               {"bone.stl", "x", "mesh"}}) {
    TemporaryFolder folder;
    write_file(folder / name, bytes);
    const std::string reason = only_refusal(folder.path());
    EXPECT_NE(reason.find(what), std::string::npos) << name << ": " << reason;
    EXPECT_NE(reason.find("DICOM"), std::string::npos) << reason;
    EXPECT_NE(reason.find("NIfTI"), std::string::npos) << reason;
  }
}

TEST(Scan, SaysOfAFileAskedForByNameThatItIsNoVolume) {
  TemporaryFolder folder;
  write_file(folder / "notes.txt", "hello");
  EXPECT_TRUE(scan(folder.path()).refused.empty());
  EXPECT_EQ(only_refusal(folder / "notes.txt"),
            "no volume of a known format; expected NIfTI, NRRD, MetaImage, image stack, DICOM");
}

TEST(Scan, NamesThatAreNoTextAreRefused) {
  TemporaryFolder folder;
  write_file(folder / "bad\xFFname.mha", small_metaimage());
  EXPECT_NE(only_refusal(folder.path()).find("UTF-8"), std::string::npos);
}

TEST(Scan, LinksOutOfTheDataFolderAreNotFollowed) {
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_file(elsewhere / "secret.mha", small_metaimage());
  fs::create_symlink(elsewhere / "secret.mha", folder / "file.mha");
  fs::create_directory_symlink(elsewhere.path(), folder / "folder");
  fs::create_directory_symlink(folder.path(), folder / "circle");
  fs::create_symlink("nowhere", folder / "dangling.mha");
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.volumes.empty());
  ASSERT_EQ(listing.refused.size(), 3U);
  for (const auto& refused : listing.refused)
    EXPECT_NE(refused.reason.find("leads out"), std::string::npos);
}

TEST(Scan, LinksToSlicesOutOfTheDataFolderAreNotFollowed) {
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_series(elsewhere / "series", ramp_series(3, {0, 0, 0}, {0, 0, 2}));
  for (const char* name : {"1.png", "2.png"})
    write_file(elsewhere / "pictures" / name, png_bytes({.pixels = std::string(20, 'v')}));
  ASSERT_EQ(scan(elsewhere.path()).volumes.size(), 2U);
  for (const auto& entry : fs::recursive_directory_iterator(elsewhere.path())) {
    if (entry.is_regular_file())
      fs::create_symlink(entry.path(), folder / entry.path().filename().string());
  }
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.volumes.empty());
  ASSERT_EQ(listing.refused.size(), 5U);
  for (const auto& refused : listing.refused)
    EXPECT_NE(refused.reason.find("leads out"), std::string::npos);
}

/// One linked slice among real ones is left out and named.
TEST(Scan, ALinkedSliceIsNoPartOfASeries) {
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_series(folder.path(), ramp_series(4, {0, 0, 0}, {0, 0, 2}));
  DicomSlice fifth;
  fifth.position_mm = {0, 0, 8};
  fifth.fill_with_ramp();
  write_dicom(elsewhere / "fifth.dcm", fifth);
  fs::create_symlink(elsewhere / "fifth.dcm", folder / "fifth.dcm");
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 1U);
  EXPECT_EQ(listing.volumes[0].geometry.size_voxels.z, 4);
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_EQ(listing.refused[0].path, folder / "fifth.dcm");
}

TEST(Scan, EmptyFilesOfEachFormatAreListed) {
  for (const char* name : {"a.dcm", "a.ima", "a.nii", "a.nii.gz", "a.hdr", "a.nrrd", "a.nhdr",
                           "a.mha", "a.mhd", "a.tif", "a.tiff", "a.png"}) {
    TemporaryFolder folder;
    write_file(folder / name, "");
    EXPECT_EQ(only_refusal(folder.path()), "the file is empty") << name;
  }
}

TEST(Scan, GroupingIsAStepOfItsOwn) {
  TemporaryFolder folder;
  write_series(folder / "dicom", ramp_series(2, {0, 0, 0}, {0, 0, 2}));
  write_file(folder / "pictures/1.png", png_bytes({.pixels = std::string(20, 'v')}));
  std::vector<std::string> steps;
  reading::ScanContext context;
  context.on_file = [&](const fs::path& file) { steps.push_back(file.extension().string()); };
  context.on_grouping = [&] { steps.emplace_back("grouping"); };
  reading::scan_in_context(folder.path(), folder.path(), std::move(context));
  const auto grouping = std::find(steps.begin(), steps.end(), "grouping");
  ASSERT_NE(grouping, steps.end());
  EXPECT_EQ(grouping + 1, steps.end());
  EXPECT_NE(std::find(steps.begin(), grouping, ".png"), grouping);
}

TEST(Scan, LinksInsideTheDataFolderCountOnce) {
  TemporaryFolder folder;
  write_file(folder / "real.mha", small_metaimage());
  fs::create_symlink("real.mha", folder / "alias.mha");
  EXPECT_EQ(only_source(folder.path(), folder.path()).description.id, "real.mha");
}

TEST(Scan, RefusesPathsThatAreNotThereOrOutside) {
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_file(elsewhere / "a.mha", small_metaimage());
  EXPECT_THROW(scan_volumes(folder / "nothing", folder.path(), {}, {}), Error);
  EXPECT_THROW(scan_volumes(elsewhere / "a.mha", folder.path(), {}, {}), Error);
  EXPECT_THROW(scan_volumes(folder.path() / ".." / elsewhere.path().filename() / "a.mha",
                            folder.path(), {}, {}),
               Error);
}

TEST(Scan, AFileThatWentAwayFailsWithItsName) {
  TemporaryFolder folder;
  write_file(folder / "a.mha", small_metaimage());
  const VolumeSource source = only_source(folder.path(), folder.path());
  fs::remove(folder / "a.mha");
  EXPECT_NE(read_failure(source).find("a.mha"), std::string::npos);
}

struct Info {
  int status = 0;
  std::string out;
  std::string errors;
};

Info info(const std::string& path, bool as_json, bool with_readers = true) {
  InfoReaders readers;
  if (with_readers) {
    readers.scan = [](const fs::path& p, const fs::path& root) {
      return scan_volumes(p, root, {}, {});
    };
    readers.read = [](const VolumeSource& source) { return read_volume(source, {}, {}, {}); };
  }
  std::ostringstream out;
  std::ostringstream errors;
  const int status = run_info({path, as_json}, readers, out, errors);
  return {status, out.str(), errors.str()};
}

TEST(InfoCommand, PrintsEveryFieldAsJson) {
  TemporaryFolder folder;
  write_file(folder / "a.mha", small_metaimage());
  write_file(folder / "b.nii", "x");
  const Info result = info(folder.path(), true);
  EXPECT_EQ(result.status, 0);
  const auto expected =
      nlohmann::json::parse(R"([{"id": "a.mha", "title": "a", "format": "MetaImage", "modality": "",
    "size": [2, 3, 4], "spacing_mm": [1, 2, 3], "origin_lps_mm": [0, 0, -5],
    "direction_lps": [0, 1, 0, 1, 0, 0, 0, 0, -1], "value_range": [97, 120], "units": "none", "warnings": []}])");
  const auto document = nlohmann::json::parse(result.out);
  auto volumes = document.at("volumes");
  EXPECT_EQ(volumes.at(0).at("first_look").at("kind"), "values of unknown units");
  volumes.at(0).erase("first_look");
  EXPECT_EQ(volumes, expected);
  ASSERT_EQ(document.at("refused").size(), 1U);
  EXPECT_EQ(document.at("refused")[0].at("path"), (folder / "b.nii").string());
  EXPECT_EQ(document.size(), 2U);
}

TEST(InfoCommand, ListsWhatBreaksOnlyWhenRead) {
  TemporaryFolder folder;
  write_file(
      folder / "a.nrrd",
      "NRRD0001\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n1 2 3 x 5 6 7 8");
  const auto document = nlohmann::json::parse(info(folder.path(), true).out);
  EXPECT_TRUE(document.at("volumes").empty());
  EXPECT_EQ(document.at("refused").size(), 1U);
}

TEST(InfoCommand, PrintsLinesForPeople) {
  TemporaryFolder folder;
  write_file(folder / "a.mha", small_metaimage());
  const Info result = info(folder / "a.mha", false);
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("2 x 3 x 4 voxels"), std::string::npos);
  EXPECT_NE(result.out.find("97 to 120"), std::string::npos);
}

TEST(InfoCommand, DescribesPhantomsAlsoWithoutReaders) {
  const Info result = info("phantom:head@32", true, false);
  EXPECT_EQ(result.status, 0) << result.errors;
  const auto volume = nlohmann::json::parse(result.out).at("volumes").at(0);
  EXPECT_EQ(volume.at("size"), nlohmann::json({32, 32, 32}));
  EXPECT_EQ(volume.at("units"), "HU");
}

TEST(InfoCommand, FailsInOneLine) {
  TemporaryFolder folder;
  write_file(folder / "broken.nii", "x");
  write_file(folder / "text.txt", "x");
  for (const std::string& path : {(folder / "broken.nii").string(), (folder / "text.txt").string(),
                                  (folder / "nothing").string(), std::string("phantom:elbow")}) {
    const Info result = info(path, true);
    EXPECT_EQ(result.status, 1) << path;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  }
  EXPECT_EQ(info(folder / "broken.nii", true, false).status, 1);
}

}  // namespace
}  // namespace cutaway::test
