// What the command line says: sizes, files to write, and what of paths a client may read.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "app/output_file.h"
#include "app/picture_size.h"
#include "services/client_words.h"

namespace cutaway {
namespace {

namespace fs = std::filesystem;

TEST(PictureSize, IsWidthTimesHeight) {
  EXPECT_EQ(parse_picture_size("640x480"), (Viewport{640, 480}));
  EXPECT_EQ(parse_picture_size("1x8192"), (Viewport{1, 8192}));
}

TEST(PictureSize, IsRefusedWhereNoPictureHasIt) {
  for (const char* text : {"", "x", "abc", "640", "640x", "x480", "640x480x2", "640 x 480", "0x0",
                           "-1x5", "8193x1", "640x480px", "99999999999x1", "1e2x5"}) {
    EXPECT_THROW(parse_picture_size(text), Error) << text;
  }
}

TEST(OutputFile, IsCheckedBeforeTheWork) {
  const fs::path folder = fs::temp_directory_path() / ("cutaway-out-" + std::to_string(getpid()));
  fs::create_directories(folder);
  EXPECT_NO_THROW(check_writable(folder / "new.png"));
  EXPECT_FALSE(fs::exists(folder / "new.png"));
  EXPECT_THROW(check_writable(folder), Error);
  EXPECT_THROW(check_writable(folder / "none" / "new.png"), Error);
  write_file(folder / "new.png", {1, 2, 3});
  EXPECT_EQ(fs::file_size(folder / "new.png"), 3U);
  EXPECT_NO_THROW(check_writable(folder / "new.png"));
  EXPECT_THROW(check_writable(folder / "new.png" / "x.png"), Error);
  fs::remove_all(folder);
}

TEST(ClientWords, BeginAtTheDataFolder) {
  EXPECT_EQ(path_for_client("/srv/data/a/b.nii", "/srv/data"), "a/b.nii");
  EXPECT_EQ(path_for_client("/srv/data/a/b.nii", "/srv/data/"), "a/b.nii");
  EXPECT_EQ(path_for_client("/srv/data", "/srv/data"), "data");
  EXPECT_EQ(path_for_client("/srv/data/", "/srv/data/"), "data");
  EXPECT_EQ(path_for_client("/elsewhere/b.nii", "/srv/data"), "b.nii");
  EXPECT_EQ(text_for_client("cannot open \"/srv/data/a.png\": /srv/data/a.png", "/srv/data"),
            "cannot open \"a.png\": a.png");
  EXPECT_EQ(text_for_client("4 bytes / voxel", "/"), "4 bytes / voxel");
}

TEST(ClientWords, NameTheFieldOfTheSceneAndTheVolume) {
  const Error told = error_for_client(
      Error({.code = ErrorCode::volume_refused, .message = "broken", .field = "/srv/data/a.nii"}),
      "a");
  EXPECT_EQ(told.detail().field, "/volume");
  EXPECT_EQ(told.detail().received, "a");
  const Error measured = error_for_client(Error({.code = ErrorCode::too_large,
                                                 .message = "too large",
                                                 .field = "/srv/data/a.nii",
                                                 .expected = "1 GiB",
                                                 .received = "2 GiB"}),
                                          "a");
  EXPECT_EQ(measured.detail().received, "2 GiB");
}

}  // namespace
}  // namespace cutaway
