#include "benchmark/frame_cases.h"

#include "scene/styles.h"

namespace cutaway::benchmark {

namespace {

const Json kKuwahara = {{"name", "kuwahara"}, {"radius", 2}};  // a window of five pixels
const Json kSobel = {{"name", "sobel"}, {"strength", 0.7}};

Json with_filters(Json scene, Json focus, Json context) {
  scene["focus"]["filters"] = std::move(focus);
  scene["context"]["filters"] = std::move(context);
  return scene;
}

}  // namespace

std::vector<FrameCase> frame_cases() {
  const Json none = Json::array();
  const Json flagship = style("flagship").scene;
  Json control = with_filters(style("phong-control").scene, none, none);
  control["lens"]["mode"] = "none";
  return {{"Phong, no lens", control},
          {"lens", with_filters(flagship, none, none)},
          {"lens + Kuwahara", with_filters(flagship, none, Json::array({kKuwahara}))},
          {"lens + Sobel", with_filters(flagship, Json::array({kSobel}), none)},
          {"lens + both", with_filters(flagship, Json::array({kSobel}), Json::array({kKuwahara}))}};
}

}  // namespace cutaway::benchmark
