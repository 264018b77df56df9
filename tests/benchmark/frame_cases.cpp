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

Json dissertation_scene() {
  return with_filters(style("dissertation").scene, Json::array({kSobel}), Json::array({kKuwahara}));
}

/// What the control draws with one more part of a picture's light or lens.
struct Addition {
  const char* name;
  Json scene;
};

std::vector<Addition> additions() {
  const Json cut = {{"mode", "cutaway"}};
  Json funnel = cut;
  funnel["opening"] = "funnel";
  Json wall = cut;
  wall["wall"] = {{"strength", 0.6}, {"deepening", 0.5}, {"edge_mm", 2.5}};
  Json section = cut;
  section["cap"] = "section";
  return {{"ramp", {{"context", {{"shading", {{"name", "ramp"}}}}}}},
          {"normals at a scale", {{"context", {{"normals", {{"scale", "auto"}}}}}}},
          {"occlusion", {{"context", {{"occlusion", {{"strength", 0.8}}}}}}},
          {"shadow", {{"context", {{"shadow", {{"strength", 0.5}}}}}}},
          {"funnel", {{"lens", funnel}}},
          {"wall", {{"lens", wall}}},
          {"section", {{"lens", section}}}};
}

void add_additions(std::vector<FrameCase>& cases) {
  for (const Addition& addition : additions()) {
    Json scene = control_scene();
    if (addition.scene.contains("context") && addition.scene["context"].contains("shading"))
      scene["context"]["shading"] = Json::object();
    scene.merge_patch(addition.scene);
    cases.push_back({std::string(addition.name) + " alone", std::move(scene)});
  }
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

FrameCase flagship_case() { return {"flagship", style("flagship").scene}; }

std::vector<FrameCase> frame_cases() {
  const Json none = Json::array();
  const Json both = dissertation_scene();
  std::vector<FrameCase> cases = {
      {"Phong, no lens", control_scene()},
      {"lens", with_filters(both, none, none)},
      {"lens + Kuwahara", with_filters(both, none, Json::array({kKuwahara}))},
      {"lens + Sobel", with_filters(both, Json::array({kSobel}), none)},
      {"lens + both", both},
      flagship_case()};
  add_lenses(cases);
  add_filters(cases);
  add_additions(cases);
  add_translucent(cases);
  return cases;
}

}  // namespace cutaway::benchmark
