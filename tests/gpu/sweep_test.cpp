// From the registries: every filter and shading model on either branch, so that none can be
// registered untested.
#include <gtest/gtest.h>

#include <set>

#include "render/filters/filter_registry.h"
#include "render/lenses/lens_registry.h"
#include "render/shading/shading_registry.h"
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

const std::shared_ptr<const LoadedVolume>& head() {
  static const auto volume = load(make_phantom({PhantomKind::head, 64}, {}, {}));
  return volume;
}

/// Nothing but what is swept decides anything that rounding could turn.
Json without_filters() {
  return {{"focus", {{"filters", Json::array()}}}, {"context", {{"filters", Json::array()}}}};
}

TEST(Sweep, EveryFilterOnEitherBranch) {
  for (const std::string& name : names_of(image_filters())) {
    for (const char* branch : {"focus", "context"}) {
      Json document = without_filters();
      document[branch]["filters"] = {{{"name", name}}};
      const Scene scene = scene_for(document, head(), {120, 90});
      expect_like_reference("filter-" + name + "-" + branch, scene, head(), settings_for(scene),
                            tolerance_for(scene));
    }
  }
}

TEST(Sweep, EveryShadingOnEitherBranch) {
  for (const std::string& name : names_of(shading_models())) {
    for (const char* branch : {"focus", "context"}) {
      Json document = without_filters();
      document[branch]["shading"] = {{"name", name}};
      const Scene scene = scene_for(document, head(), {120, 90});
      expect_like_reference("shading-" + name + "-" + branch, scene, head(), settings_for(scene),
                            tolerance_for(scene));
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

TEST(Sweep, EveryStyle) {
  for (const Style& style : styles()) {
    const Scene scene = scene_for(style.scene, head(), {120, 90});
    expect_like_reference("style-" + style.name, scene, head(), settings_for(scene),
                          tolerance_for(scene));
  }
}

}  // namespace
}  // namespace cutaway::test
