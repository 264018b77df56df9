// What a change of the scene costs: stages run only when what they read has changed.
#include <gtest/gtest.h>

#include "scene/modules.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

class Stages : public testing::Test {
 protected:
  Stages() : volume_(load(shells_volume(centred_geometry(64)))), gpu_volume_(volume_, 2048) {
    gpu_volume_.upload_rest();
    document_ = {
        {"camera", {{"eye_mm", {0, -250, 30}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}}},
        {"lens", {{"centre_mm", {0, -40, 0}}, {"radius_mm", 20}}}};
    render();
  }

  void render() {
    const Scene scene = scene_for(document_, volume_, {80, 60});
    RenderSettings settings = settings_for(scene);
    settings.layout = PixelLayout::yuv420;
    gpu_.pipeline().render(view_, scene, gpu_volume_, settings);
  }

  /// What one more render adds to the counts.
  StageCounts cost_of_render() {
    const StageCounts before = view_.counts();
    render();
    const StageCounts after = view_.counts();
    return {.entry = after.entry - before.entry,
            .ray_cast = after.ray_cast - before.ray_cast,
            .shade = {after.shade[0] - before.shade[0], after.shade[1] - before.shade[1]},
            .filters = {after.filters[0] - before.filters[0], after.filters[1] - before.filters[1]},
            .composite = after.composite - before.composite,
            .convert = after.convert - before.convert};
  }

  GpuHarness& gpu_ = GpuHarness::instance();  ///< first: what follows needs its context
  std::shared_ptr<const LoadedVolume> volume_;
  GpuVolume gpu_volume_;
  ViewState view_;
  Json document_;
};

TEST_F(Stages, AnUnchangedSceneCostsNothing) { EXPECT_EQ(cost_of_render(), StageCounts{}); }

TEST_F(Stages, AToneSliderNeverCastsARayAndLeavesTheOtherBranchAlone) {
  document_["focus"]["shading"] = {{"name", "tone"}, {"detail", 0.3}};
  EXPECT_EQ(cost_of_render(),
            (StageCounts{.shade = {0, 1}, .filters = {0, 1}, .composite = 1, .convert = 1}));
}

TEST_F(Stages, AFilterParameterRunsThatFilterAndTheComposite) {
  document_["context"]["filters"] = {{{"name", "kuwahara"}, {"radius", 3}}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.filters = {1, 0}, .composite = 1, .convert = 1}));
}

TEST_F(Stages, AFilterBehindAnUnchangedOneRunsAlone) {
  document_["context"]["filters"] = {{{"name", "kuwahara"}, {"radius", 2}},
                                     {{"name", "sobel"}, {"strength", 0.5}}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.filters = {1, 0}, .composite = 1, .convert = 1}));
  document_["context"]["filters"][1]["strength"] = 0.6;
  EXPECT_EQ(cost_of_render(), (StageCounts{.filters = {1, 0}, .composite = 1, .convert = 1}));
  document_["context"]["filters"].erase(1);
  EXPECT_EQ(cost_of_render(), (StageCounts{.composite = 1, .convert = 1}));
}

/// A legal value of a parameter, as the schema describes it, that is not its default.
Json another_value(const Json& parameter) {
  const Json& usual = parameter.at("default");
  const auto type = parameter.at("type").get<std::string>();
  if (type == "boolean") return !usual.get<bool>();
  if (type == "colour") return {0.11, 0.22, 0.33};
  if (type == "choice") {
    const Json& choices = parameter.at("choices");
    return choices.at(0) == usual ? choices.at(1) : choices.at(0);
  }
  return usual == parameter.at("maximum") ? parameter.at("minimum") : parameter.at("maximum");
}

/// Calls `change(module's name, parameter's name, another value)` for all of a registry.
template <typename Change>
void each_parameter(const char* registry, Change&& change) {
  for (const Json& module : describe_modules().at(registry)) {
    for (const Json& parameter : module.at("parameters")) {
      change(module.at("name").get<std::string>(), parameter.at("name").get<std::string>(),
             another_value(parameter));
    }
  }
}

constexpr const char* kBranchNames[kBranches] = {"context", "focus"};

TEST_F(Stages, EachParameterOfAShadingRunsItsBranchFromTheShadingOn) {
  int changed = 0;
  for (const BranchIndex branch : {kContext, kFocus}) {
    StageCounts expected{.composite = 1, .convert = 1};
    expected.shade[branch] = 1;
    expected.filters[branch] = 2;
    document_[kBranchNames[branch]]["filters"] = {{{"name", "kuwahara"}}, {{"name", "sobel"}}};
    each_parameter(
        "shading", [&](const std::string& name, const std::string& parameter, const Json& value) {
          Json& shading = document_[kBranchNames[branch]]["shading"];
          shading = {{"name", name}};
          render();
          shading[parameter] = value;
          EXPECT_EQ(cost_of_render(), expected) << kBranchNames[branch] << " " << name << parameter;
          EXPECT_EQ(cost_of_render(), StageCounts{});
          ++changed;
        });
  }
  EXPECT_GE(changed, 2 * 16);
}

TEST_F(Stages, EachParameterOfAFilterRunsItAndWhatComesBehind) {
  int changed = 0;
  const auto expect_cost = [&](BranchIndex branch, const std::string& name,
                               const std::string& parameter, const Json& value) {
    const char* other = name == "sobel" ? "kuwahara" : "sobel";
    for (const std::size_t place : {0, 1}) {
      Json& filters = document_[kBranchNames[branch]]["filters"];
      filters = {{{"name", other}}, {{"name", other}}};
      filters[place] = {{"name", name}};
      render();
      filters[place][parameter] = value;
      StageCounts expected{.composite = 1, .convert = 1};
      expected.filters[branch] = 2 - place;
      EXPECT_EQ(cost_of_render(), expected) << kBranchNames[branch] << " " << name << parameter;
      ++changed;
    }
  };
  for (const BranchIndex branch : {kContext, kFocus}) {
    each_parameter("filter",
                   [&](const std::string& name, const std::string& parameter, const Json& value) {
                     expect_cost(branch, name, parameter, value);
                   });
  }
  EXPECT_GE(changed, 2 * 2 * 8);
}

TEST_F(Stages, TheLightIsTheShadingsOfBothBranches) {
  document_["context"]["filters"] = {{{"name", "kuwahara"}}};
  document_["focus"]["filters"] = {{{"name", "sobel"}}, {{"name", "kuwahara"}}};
  render();
  document_["light"] = {{"direction", {0.3, 0.2, 0.9}}};
  EXPECT_EQ(cost_of_render(),
            (StageCounts{.shade = {1, 1}, .filters = {1, 2}, .composite = 1, .convert = 1}));
}

TEST_F(Stages, WhatOnlyTheMagicLensReadsCostsTheCutawayNothing) {
  const Json changes = {{"strength", 0.3}, {"softness", 0.8}, {"strict", true}};
  for (const auto& [name, value] : changes.items()) {
    document_["lens"][name] = value;
    EXPECT_EQ(cost_of_render(), StageCounts{}) << name;
  }
  document_["lens"] = {{"mode", "magic"}, {"centre_mm", {0, -40, 0}}, {"radius_mm", 20}};
  render();
  for (const auto& [name, value] : changes.items()) {
    document_["lens"][name] = value;
    EXPECT_EQ(cost_of_render(), (StageCounts{.composite = 1, .convert = 1})) << name;
  }
}

TEST_F(Stages, OfATranslucentSceneShadeWhileTheyCastRays) {
  // Layers are coloured on the way: a tone slider of either branch casts rays again, and both
  // branches are resolved from them. Filters and the background still cost what they read.
  document_["context"]["filters"] = {{{"name", "kuwahara"}}};
  document_["focus"]["filters"] = {{{"name", "sobel"}}};
  document_["context"]["surface"] = {{"opacity", 0.1}};
  render();
  const StageCounts all{
      .ray_cast = 1, .shade = {1, 1}, .filters = {1, 1}, .composite = 1, .convert = 1};
  document_["focus"]["shading"] = {{"name", "tone"}, {"detail", 0.3}};
  EXPECT_EQ(cost_of_render(), all);
  document_["light"] = {{"direction", {0.3, 0.2, 0.9}}};
  EXPECT_EQ(cost_of_render(), all);
  document_["focus"]["filters"][0]["strength"] = 0.3;
  EXPECT_EQ(cost_of_render(), (StageCounts{.filters = {0, 1}, .composite = 1, .convert = 1}));
  document_["background"] = {{"colour", {0.5, 0.5, 0.5}}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.composite = 1, .convert = 1}));
}

TEST_F(Stages, TheBackgroundIsTheCompositesOwn) {
  document_["background"] = {{"colour", {0.5, 0.5, 0.5}}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.composite = 1, .convert = 1}));
}

TEST_F(Stages, AMovedLensOrCameraCastsRays) {
  document_["lens"]["centre_mm"] = {5, -40, 0};
  EXPECT_EQ(cost_of_render().ray_cast, 1U);
  document_["camera"]["eye_mm"] = {20, -250, 30};
  EXPECT_EQ(cost_of_render().ray_cast, 1U);
}

TEST_F(Stages, AnotherVolumeAtTheLastOnesAddressIsCastAnew) {
  LoadedVolume place = *load(sphere_volume(centred_geometry(64), 25.0));
  const auto cast_from_there = [&] {
    const std::shared_ptr<const LoadedVolume> volume(&place, [](const LoadedVolume*) {});
    GpuVolume gpu_volume(volume, 2048);
    gpu_volume.upload_rest();
    const Scene scene =
        scene_for({{"context", {{"surface", {{"iso_value", 0}}}}},
                   {"camera", document_.at("camera")},
                   {"focus", {{"surface", {{"iso_value", 5}}}}},
                   {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}}},
                  volume, {80, 60});
    gpu_.pipeline().render(view_, scene, gpu_volume, settings_for(scene));
    return FramePipeline::read_surface(view_, kContext)[30 * 80 + 40].w;
  };
  const float first = cast_from_there();
  place = *load(sphere_volume(centred_geometry(64), 15.0));
  EXPECT_NEAR(cast_from_there() - first, 10.0, 0.5);
}

TEST_F(Stages, EachSampleBelongsToOneBranchOrTheBackground) {
  const auto context = FramePipeline::read_surface(view_, kContext);
  const auto focus = FramePipeline::read_surface(view_, kFocus);
  int held[3] = {0, 0, 0};
  for (std::size_t i = 0; i < context.size(); ++i) {
    const int holders = (context[i].w >= 0.0F ? 1 : 0) + (focus[i].w >= 0.0F ? 1 : 0);
    ASSERT_LE(holders, 1);
    ++held[holders == 0 ? 2 : focus[i].w >= 0.0F ? 1 : 0];
  }
  for (const int pixels : held) EXPECT_GT(pixels, 50);
}

}  // namespace
}  // namespace cutaway::test
