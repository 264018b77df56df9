// From the registries: every filter and shading model on either branch, so that none can be
// registered untested.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "render/filters/filter_registry.h"
#include "render/shading/shading_registry.h"
#include "scene/json_text.h"
#include "scene/lenses/lens_shape.h"
#include "scene/modules.h"
#include "scene/styles.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"
#include "volume/phantoms.h"

namespace cutaway::test {
namespace {

template <typename Registry>
std::set<std::string> names_of(const Registry& registry) {
  std::set<std::string> names;
  for (const auto& entry : registry) names.insert(entry.name);
  return names;
}

std::set<std::string> described(const char* kind) {
  std::set<std::string> names;
  for (const Json& module : describe_modules().at(kind))
    names.insert(module.at("name").get<std::string>());
  return names;
}

TEST(Registries, HoldWhatTheSchemaDescribes) {
  EXPECT_EQ(names_of(image_filters()), described("filter"));
  EXPECT_EQ(names_of(shading_models()), described("shading"));
  EXPECT_EQ(names_of(lens_shapes()), described("lens_shape"));
}

const std::shared_ptr<const LoadedVolume>& swept_head() {
  static const auto volume = load(make_phantom({PhantomKind::head, 64}, {}, {}));
  return volume;
}

/// What a first look would choose is no part of what is swept.
Json with_iso_values(Json document) {
  document["context"]["surface"] = {{"iso_value", -200}};
  document["focus"]["surface"] = {{"iso_value", 250}};
  return document;
}

/// Nothing but what is swept decides anything that rounding could turn.
Json without_filters() {
  return with_iso_values(
      {{"focus", {{"filters", Json::array()}}}, {"context", {{"filters", Json::array()}}}});
}

TEST(Sweep, EveryFilterOnEitherBranch) {
  for (const std::string& name : names_of(image_filters())) {
    for (const char* branch : {"focus", "context"}) {
      Json document = without_filters();
      document[branch]["filters"] = {{{"name", name}}};
      const Scene scene = scene_for(document, swept_head(), {120, 90});
      expect_like_reference("filter-" + name + "-" + branch, scene, swept_head(),
                            settings_for(scene), tolerance_for(scene));
    }
  }
}

TEST(Sweep, EveryShadingOnEitherBranch) {
  for (const std::string& name : names_of(shading_models())) {
    for (const char* branch : {"focus", "context"}) {
      Json document = without_filters();
      document[branch]["shading"] = {{"name", name}};
      const Scene scene = scene_for(document, swept_head(), {120, 90});
      expect_like_reference("shading-" + name + "-" + branch, scene, swept_head(),
                            settings_for(scene), tolerance_for(scene));
    }
  }
}

TEST(Sweep, EveryLensOnEveryPhantom) {
  for (const PhantomKind kind : {PhantomKind::head, PhantomKind::abdomen, PhantomKind::knees}) {
    const auto volume = load(make_phantom({kind, 64}, {}, {}));
    for (const std::string& shape : names_of(lens_shapes())) {
      for (const char* mode : {"none", "cutaway", "magic"}) {
        Json document = without_filters();
        document["lens"] = {{"shape", {{"name", shape}}}, {"mode", mode}};
        const Scene scene = scene_for(document, volume, {120, 90});
        expect_like_reference(
            "lens-" + shape + "-" + mode + "-" + std::to_string(static_cast<int>(kind)), scene,
            volume, settings_for(scene), tolerance_for(scene));
      }
    }
  }
}

/// What a parameter is tried at: both ends of its range and somewhere between, since the ends of an
/// angle are one; each of its choices.
std::vector<Json> extremes_of(const Json& parameter) {
  const std::string type = parameter.at("type");
  if (type == "boolean") return {false, true};
  if (type == "colour") return {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}};
  if (type == "choice") return parameter.at("choices").get<std::vector<Json>>();
  const double low = parameter.at("minimum");
  const double high = parameter.at("maximum");
  const double between = low + 0.37 * (high - low);
  if (type == "integer") return {int(low), int(high), int(between)};
  return {low, high, between};
}

/// Where it takes another parameter for this one to be read at all.
Json premise_of(const std::string& parameter) {
  if (parameter == "depth_step_mm") return {{"source", "depth"}};
  if (parameter.starts_with("softness")) return {{"detail", 0}};
  if (parameter.starts_with("step_")) return {{"step", 0.5}};
  return Json::object();
}

/// A module's parameters, each length in both of its units.
std::vector<Json> parameters_of(const Json& module) {
  std::vector<Json> parameters;
  for (const Json& parameter : module.at("parameters")) {
    parameters.push_back(parameter);
    if (!parameter.contains("relative")) continue;
    parameters.push_back(parameter.at("relative"));
    parameters.back()["type"] = "number";
  }
  return parameters;
}

/// One pixel of the head at this size lies where the field is nearly flat: rounding turns its
/// normal a little, and the steepest parameters make up to 4 levels of that.
Tolerance tolerance_at_extremes(const Scene& scene) {
  Tolerance tolerance = tolerance_for(scene);
  // A ramp is a table of 81 colours: on the way to a pure one the eye's steps bend more than that.
  if (scene.context.shading.name == "ramp") {
    tolerance.maximum = std::max(tolerance.maximum, 24);
    tolerance.share_above_2 = std::max(tolerance.share_above_2, 0.01);
  }
  tolerance.maximum = std::max(tolerance.maximum, 5);
  tolerance.share_above_2 = std::max(tolerance.share_above_2, 0.0005);
  return tolerance;
}

/// Each parameter of a registry's modules at its extremes like the reference, and none without an
/// effect. `place` puts a module into a document.
void sweep_parameters(const char* kind, const std::function<Json(Json module)>& place) {
  for (const Json& module : describe_modules().at(kind)) {
    for (const Json& parameter : parameters_of(module)) {
      const std::string name = parameter.at("name");
      Json usual = premise_of(name);
      usual["name"] = module.at("name");
      const auto scene_with = [&](const Json& chosen) {
        return scene_for(place(chosen), swept_head(), {96, 72});
      };
      const auto draw = [&](const Scene& scene) {
        return GpuHarness::instance().render(scene, swept_head(), settings_for(scene)).rgba;
      };
      const auto plain = draw(scene_with(usual));
      bool has_an_effect = false;
      for (const Json& value : extremes_of(parameter)) {
        Json chosen = usual;
        chosen[name] = value;
        const Scene scene = scene_with(chosen);
        expect_like_reference(std::string(kind) + "-" + json_text(chosen), scene, swept_head(),
                              settings_for(scene), tolerance_at_extremes(scene));
        has_an_effect = has_an_effect || draw(scene) != plain;
      }
      EXPECT_TRUE(has_an_effect) << kind << " " << module.at("name") << " " << name;
    }
  }
}

TEST(Sweep, EveryParameterOfShading) {
  sweep_parameters("shading", [](Json module) {
    Json document = without_filters();
    document["context"]["shading"] = std::move(module);
    return document;
  });
}

TEST(Sweep, EveryParameterOfFilters) {
  sweep_parameters("filter", [](Json module) {
    Json document = without_filters();
    document["context"]["filters"] = {std::move(module)};
    return document;
  });
}

TEST(Sweep, EveryParameterOfLenses) {
  for (const char* mode : {"cutaway", "magic"}) {
    sweep_parameters("lens_shape", [mode](Json module) {
      Json document = without_filters();
      // Placed, and turned against every axis, so that no angle is without an effect.
      for (const char* angle : {"azimuth_degrees", "elevation_degrees"})
        if (!module.contains(angle) && module.at("name") != "sphere") module[angle] = 25;
      document["lens"] = {{"mode", mode},
                          {"centre_mm", {10, -70, 15}},
                          {"radius_mm", 45},
                          {"shape", std::move(module)}};
      return document;
    });
  }
}

/// Rays for light ask at few places whether something is in the way, and the reference integrates a
/// Gaussian that taps sample: a ramp's colours, an outline's line and a stroke hang on either.
Tolerance style_tolerance(const Scene& scene) {
  const auto is_lit = [](const Branch& branch) {
    return branch.occlusion.strength > 0.0 || branch.shadow.strength > 0.0 ||
           branch.normals.scale == NormalScale::automatic;
  };
  if (!is_lit(scene.context) && !is_lit(scene.focus)) return tolerance_for(scene);
  return {.mean = 0.5, .share_above_2 = 0.06, .maximum = 128, .share_of_disagreements = 0.001};
}

TEST(Sweep, EveryStyle) {
  for (const Style& style : styles()) {
    const Scene scene = scene_for(with_iso_values(style.scene), swept_head(), {120, 90});
    expect_like_reference("style-" + style.name, scene, swept_head(), settings_for(scene),
                          style_tolerance(scene));
  }
}

}  // namespace
}  // namespace cutaway::test
