#include "benchmark/options.h"

#include <gtest/gtest.h>

#include "benchmark/volumes.h"
#include "core/error.h"

namespace cutaway::benchmark {
namespace {

Options parsed(const std::string& line) {
  CLI::App app;
  Options options;
  add_options(app, options);
  app.parse(line);
  return options;
}

TEST(Options, MeasureFramesOfPhantomsOf256VoxelsWhereNothingIsSaid) {
  const Options options = parsed("");
  EXPECT_EQ(options.phantom_sizes_voxels, std::vector<int>{256});
  EXPECT_TRUE(options.jpeg_threads.empty());
}

TEST(Options, TakeSeveralSizesAndNumbersOfThreads) {
  const Options options = parsed("--phantom-size 64 128 --jpeg-threads 1 2 4");
  EXPECT_EQ(options.phantom_sizes_voxels, (std::vector<int>{64, 128}));
  EXPECT_EQ(options.jpeg_threads, (std::vector<int>{1, 2, 4}));
}

TEST(Options, RefuseNoThreads) { EXPECT_THROW(parsed("--jpeg-threads 0"), CLI::ValidationError); }

TEST(PictureSize, IsWidthByHeight) {
  EXPECT_EQ(parse_size("1280x720"), (Viewport{1280, 720}));
  for (const char* wrong :
       {"", "512", "512x", "x512", "512x512x3", "0x512", "512x-1", "a512x512"}) {
    try {
      parse_size(wrong);
      ADD_FAILURE() << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.detail().field, "--sizes");
      EXPECT_EQ(error.detail().received, wrong);
    }
  }
}

TEST(VolumesToMeasure, AreEachPhantomAtEachSize) {
  std::vector<std::string> names;
  for (const NamedVolume& each : volumes_to_measure({32, 256}, {})) names.push_back(each.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"phantom:head@32", "phantom:head", "phantom:abdomen@32",
                                      "phantom:abdomen", "phantom:knees@32", "phantom:knees"}));
}

}  // namespace
}  // namespace cutaway::benchmark
