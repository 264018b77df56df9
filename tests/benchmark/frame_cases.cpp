#include "benchmark/frame_cases.h"

#include "render/filters/filter_registry.h"
#include "scene/lenses/lens_shape.h"
#include "scene/schema.h"
#include "scene/styles.h"

namespace cutaway::benchmark {

namespace {

const Json kKuwahara = {{"name", "kuwahara"}, {"radius", 2}};  // a window of five pixels
const Json kSobel = {{"name", "sobel"}, {"strength", 0.7}};
constexpr double kTranslucent = 0.02;  // opacity of one millimetre: rays go deep

Json with_filters(Json scene, Json focus, Json context) {
  scene["focus"]["filters"] = std::move(focus);
  scene["context"]["filters"] = std::move(context);
  return scene;
}

Json control_scene() {
  Json control = with_filters(style("phong-control").scene, Json::array(), Json::array());
  control["lens"]["mode"] = "none";
  return control;
}

Json flagship_scene() {
  return with_filters(style("flagship").scene, Json::array({kSobel}), Json::array({kKuwahara}));
}

void add_lenses(std::vector<FrameCase>& cases) {
  for (const Json& mode :
       schema("scene").at("/properties/lens/properties/mode/enum"_json_pointer)) {
    if (mode == "none") continue;
    for (const LensShape& shape : lens_shapes()) {
      Json scene = control_scene();
      scene["lens"]["mode"] = mode;
      scene["lens"]["shape"] = {{"name", shape.name}};
      cases.push_back({mode.get<std::string>() + ' ' + shape.name + " alone", std::move(scene)});
    }
  }
}

void add_filters(std::vector<FrameCase>& cases) {
  for (const ImageFilter& filter : image_filters()) {
    Json scene = control_scene();
    scene["context"]["filters"] = Json::array({{{"name", filter.name}}});
    cases.push_back({std::string(filter.name) + " alone", std::move(scene)});
  }
}

void add_translucent(std::vector<FrameCase>& cases) {
  Json scene = control_scene();
  scene["context"]["surface"]["opacity"] = kTranslucent;
  cases.push_back({"translucent alone", std::move(scene)});
}

}  // namespace

FrameCase flagship_case() { return {"lens + both", flagship_scene()}; }

std::vector<FrameCase> frame_cases() {
  const Json none = Json::array();
  const Json flagship = flagship_scene();
  std::vector<FrameCase> cases = {
      {"Phong, no lens", control_scene()},
      {"lens", with_filters(flagship, none, none)},
      {"lens + Kuwahara", with_filters(flagship, none, Json::array({kKuwahara}))},
      {"lens + Sobel", with_filters(flagship, Json::array({kSobel}), none)},
      flagship_case()};
  add_lenses(cases);
  add_filters(cases);
  add_translucent(cases);
  return cases;
}

}  // namespace cutaway::benchmark
