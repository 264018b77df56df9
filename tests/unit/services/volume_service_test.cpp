// What there is to open, and what an open volume says; on small phantoms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/schema.h"
#include "unit/services/volume_waiter.h"

namespace cutaway {
namespace {

using testing::Heard;
using testing::no_renderer;

TEST(VolumeService, ListsThePhantomsAsTheSchemaWants) {
  const VolumeService service{VolumeSettings{}, no_renderer()};
  const Json listing = service.listing();
  validate(listing, "volumes");
  std::vector<std::string> ids;
  for (const Json& volume : listing["volumes"]) ids.push_back(volume["id"]);
  EXPECT_THAT(ids, ::testing::ElementsAre("phantom:head", "phantom:abdomen", "phantom:knees"));
}

TEST(VolumeService, LoadsAPhantomThroughAllStages) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const auto volume = heard.volume();
  EXPECT_EQ(volume->facts().id, "phantom:head@32");
  EXPECT_EQ(volume->units(), "HU");
  EXPECT_EQ(heard.stages().back(), LoadStage::upload);
  EXPECT_THAT(heard.stages(), ::testing::Contains(LoadStage::min_max));
  EXPECT_NE(service.loaded("phantom:head@32"), nullptr);
  EXPECT_EQ(service.loaded("phantom:knees"), nullptr);
}

TEST(VolumeService, SaysWhatASceneMessageNeeds) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const Json summary = heard.volume()->summary();
  validate({{"type", "scene"},
            {"revision", 1},
            {"input", 0},
            {"scene", Json::object()},
            {"volume", summary}},
           "server-message");
  std::uint64_t voxels = 0;
  for (const Json& count : summary["histogram"]) voxels += count.get<std::uint64_t>();
  EXPECT_EQ(voxels, 32U * 32U * 32U);
}

TEST(VolumeService, KnowsTheValueInsideAndNothingOutside) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const auto volume = heard.volume();
  const VolumeFacts& facts = volume->facts();
  const glm::dvec3 to_corner_mm = facts.grid_half_axes_mm * glm::dvec3(1.0);
  const auto corner = volume->value_at(facts.grid_centre_mm - (31.0 / 32.0) * to_corner_mm);
  ASSERT_TRUE(corner.has_value());
  EXPECT_NEAR(*corner, -1000.0, 200.0);  // air around the head
  EXPECT_EQ(volume->value_at(facts.grid_centre_mm - to_corner_mm), std::nullopt);
  EXPECT_EQ(volume->value_at(facts.grid_centre_mm + to_corner_mm), std::nullopt);
}

TEST(VolumeService, FindsTheSkinWithARay) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const auto volume = heard.volume();
  const VolumeFacts& facts = volume->facts();
  const glm::dvec3 centre = 0.5 * (facts.bounds_minimum_mm + facts.bounds_maximum_mm);
  const glm::dvec3 front = centre - glm::dvec3(0.0, facts.diagonal_mm, 0.0);
  const auto skin = facts.first_surface_mm(front, {0.0, 1.0, 0.0}, {facts.outer_iso_value});
  ASSERT_TRUE(skin.has_value());
  EXPECT_NEAR(volume->value_at(*skin).value(), facts.outer_iso_value, 50.0);
}

TEST(VolumeService, UnknownVolumesAreRefused) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  for (const char* id :
       {"nowhere", "", "../../etc/passwd", "phantom:unicorn", "phantom:head@9999"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    EXPECT_THAT(heard.error_code(),
                ::testing::AnyOf(ErrorCode::unknown_volume, ErrorCode::out_of_range))
        << id;
  }
}

TEST(VolumeService, AskingForWhatThereIsNotLeavesTheLogAlone) {
  ::testing::internal::CaptureStderr();
  VolumeService service{VolumeSettings{}, no_renderer()};
  for (const char* id : {"nowhere\nat all", "phantom:unicorn", "phantom:head@9999"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    heard.outcome();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(VolumeService, AFolderThatCannotBeScannedIsListedWithItsReason) {
  VolumeService service{VolumeSettings{.data = {"/nowhere/at/all"}}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("anything", heard.progress(), heard.done());
  EXPECT_EQ(heard.error_code(), ErrorCode::unknown_volume);  // answered once the scan has ended
  ASSERT_EQ(service.listing()["refused"].size(), 1);
  EXPECT_EQ(service.listing()["refused"][0]["path"], "all");
  EXPECT_THAT(service.listing().dump(), ::testing::Not(::testing::HasSubstr("/nowhere")));
}

TEST(VolumeService, WhatTheRendererCannotHoldIsRefusedBeforeAVoxelIsRead) {
  UploadTarget small = no_renderer();
  small.largest_edge_voxels = 48;
  VolumeService service{VolumeSettings{}, small};
  Heard heard;
  const auto ticket = service.open("phantom:head@64", heard.progress(), heard.done());
  const Error::Detail refusal = heard.error().detail();
  EXPECT_EQ(refusal.code, ErrorCode::volume_refused);
  EXPECT_EQ(refusal.field, "/volume");
  EXPECT_EQ(refusal.expected, "at most 48 voxels an edge");
  EXPECT_EQ(refusal.received, "64");
  EXPECT_TRUE(heard.stages().empty());
}

}  // namespace
}  // namespace cutaway
