// Volumes of files: their scan, and what is said of where they lie.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scene/schema.h"
#include "unit/services/volume_waiter.h"

namespace cutaway {
namespace {

using testing::Heard;
using testing::no_renderer;

/// A folder of this test's own, gone with it.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("cutaway-" + name + "-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_ / "inner");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
  }

 private:
  std::filesystem::path path_;
};

constexpr const char* kVolume =
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678";

TEST(VolumeFiles, NeverSaysWhereFilesLie) {
  const Folder folder("paths");
  folder.write("inner/good.nrrd", kVolume);
  folder.write("inner/short.nrrd", std::string(kVolume).substr(0, 66));
  VolumeService service{VolumeSettings{.data = {folder.path()}}, no_renderer()};
  Heard scanned;
  const auto scan = service.open("not there", scanned.progress(), scanned.done());
  EXPECT_EQ(scanned.error_code(), ErrorCode::unknown_volume);
  const Json listing = service.listing();
  ASSERT_EQ(listing["refused"].size(), 1);
  ASSERT_EQ(listing["volumes"].size(), 4);  // the phantoms, too
  EXPECT_EQ(listing["refused"][0]["path"], "inner/short.nrrd");
  EXPECT_THAT(listing.dump(), ::testing::Not(::testing::HasSubstr(folder.path().string())));
  const std::string id = listing["volumes"][0]["id"];
  folder.write("inner/good.nrrd", "something else now");
  Heard heard;
  const auto ticket = service.open(id, heard.progress(), heard.done());
  EXPECT_EQ(heard.error().detail().field, "/volume");
  EXPECT_THAT(heard.error().what(), ::testing::Not(::testing::HasSubstr(folder.path().string())));
}

TEST(VolumeFiles, OffersTheFileThatANamedLinkLeadsTo) {
  const Folder folder("links");
  folder.write("inner/real.nrrd", kVolume);
  std::filesystem::create_directories(folder.path() / "elsewhere");
  const auto link = folder.path() / "elsewhere/link.nrrd";
  std::filesystem::create_symlink("../inner/real.nrrd", link);
  VolumeService service{VolumeSettings{.data = {link}}, no_renderer()};
  Heard scanned;
  const auto scan = service.open("not there", scanned.progress(), scanned.done());
  EXPECT_EQ(scanned.error_code(), ErrorCode::unknown_volume);
  const Json listing = service.listing();
  EXPECT_TRUE(listing["refused"].empty()) << listing;
  Heard heard;
  const auto ticket = service.open(listing["volumes"][0]["id"], heard.progress(), heard.done());
  EXPECT_EQ(heard.volume()->summary()["size_voxels"], Json({2, 2, 2}));
}

/// A program that answers as a reader of volumes does after so long.
std::filesystem::path slow_reader(const Folder& folder, const std::string& seconds) {
  folder.write("reader", "#!/bin/sh\nsleep " + seconds + "\n");
  std::filesystem::permissions(folder.path() / "reader", std::filesystem::perms::owner_all);
  return folder.path() / "reader";
}

TEST(VolumeFiles, WhoWaitsForTheScanHoldsUpNobody) {
  const Folder folder("slow-scan");
  VolumeService service{
      VolumeSettings{
          .data = {folder.path()}, .load_threads = 1, .reader = slow_reader(folder, "1000")},
      no_renderer()};
  std::array<Heard, 3> waiting;
  std::vector<std::unique_ptr<OpenTicket>> tickets;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    tickets.push_back(
        service.open("file" + std::to_string(i), waiting[i].progress(), waiting[i].done()));
  }
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  EXPECT_NE(heard.volume(), nullptr);
  for (Heard& each : waiting) EXPECT_EQ(each.outcomes(), 0);
}

TEST(VolumeFiles, SaysWhetherItStillLooksForVolumes) {
  EXPECT_EQ((VolumeService{VolumeSettings{}, no_renderer()}.listing()["scanning"]), false);
  const Folder folder("scanning");
  VolumeService service{
      VolumeSettings{.data = {folder.path()}, .reader = slow_reader(folder, "0.3")}, no_renderer()};
  EXPECT_EQ(service.listing()["scanning"], true);
  validate(service.listing(), "volumes");
  Heard heard;
  const auto ticket = service.open("file", heard.progress(), heard.done());
  heard.outcome();  // at the scan's end
  EXPECT_EQ(service.listing()["scanning"], false);
}

TEST(VolumeFiles, WhoWaitsForTheScanIsAnsweredAtItsEnd) {
  const Folder folder("end-of-scan");
  VolumeService service{
      VolumeSettings{.data = {folder.path()}, .reader = slow_reader(folder, "0.3")}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("file", heard.progress(), heard.done());
  EXPECT_EQ(heard.error_code(), ErrorCode::unknown_volume);
}

TEST(VolumeFiles, FindsAndOpensARealVolume) {
  const char* data = std::getenv("CUTAWAY_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "CUTAWAY_TEST_DATA is not set";
  const auto folder = std::filesystem::path(data) / "head_mr_seg3d_nii";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  VolumeService service{VolumeSettings{.data = {folder}}, no_renderer()};
  Heard scanned;
  const auto scan = service.open("not there", scanned.progress(), scanned.done());
  EXPECT_EQ(scanned.error_code(), ErrorCode::unknown_volume);
  const Json listing = service.listing();
  validate(listing, "volumes");
  const std::string id = listing["volumes"][0]["id"];
  Heard heard;
  const auto ticket = service.open(id, heard.progress(), heard.done());
  EXPECT_EQ(heard.volume()->summary()["size_voxels"], Json({160, 232, 160}));
}

}  // namespace
}  // namespace cutaway
