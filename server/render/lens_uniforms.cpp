#include "render/lens_uniforms.h"

#include <algorithm>

#include "scene/lenses/lens_body.h"

namespace cutaway {

std::vector<std::string> lens_body_files() {
  std::vector<std::string> files;
  for (const LensShape& shape : lens_shapes()) {
    if (std::ranges::find(files, shape.body->shader) == files.end())
      files.emplace_back(shape.body->shader);
  }
  return files;
}

std::string lens_body_file(const Lens& lens) {
  return find_lens_shape(lens.shape.name).body->shader;
}

std::map<std::string, std::string> lens_definitions(const std::string& body_file) {
  return {{"LENS_BODY", '"' + body_file + '"'}};
}

void set_lens_body(const gl::Program& program, const Lens& lens) {
  const LensBody body(lens);
  program.set("lens_centre_mm", glm::vec3(body.centre_mm()));
  program.set("body_from_patient", glm::mat3(body.body_from_patient()));
  program.set("body_per_mm", static_cast<float>(body.body_per_mm()));
}

void set_funnel(const gl::Program& program, const std::optional<Funnel>& funnel) {
  const Funnel opened = funnel.value_or(Funnel{});
  program.set("funnel_foot_mm", glm::vec3(opened.foot_mm));
  program.set("funnel_axis", glm::vec3(opened.axis));
  program.set("funnel_radius_mm", static_cast<float>(opened.radius_mm));
  program.set("funnel_widening", static_cast<float>(opened.widening));
}

}  // namespace cutaway
