#include "support/reference_flow.h"

#include <cmath>

namespace cutaway::reference {

namespace {

/// Sobel's derivatives; where the branch has nothing the middle's colour goes on.
glm::dvec4 tensor_at(const BranchImage& input, const Field& colours, glm::ivec2 at) {
  if (input.at(at).coverage == 0.0) return glm::dvec4(0.0);
  const auto colour = [&](int x, int y) {
    const glm::ivec2 there = glm::clamp(at + glm::ivec2(x, y), glm::ivec2(0), input.size_px - 1);
    return mean(colours.at(input.at(there).coverage > 0.0 ? there : at));
  };
  glm::dvec3 across(0.0);
  glm::dvec3 down(0.0);
  for (const int i : {-1, 0, 1}) {
    const double weight = i == 0 ? 0.5 : 0.25;
    across += weight * (colour(1, i) - colour(-1, i));
    down += weight * (colour(i, 1) - colour(i, -1));
  }
  return {glm::dot(across, across), glm::dot(across, down), glm::dot(down, down), 1.0};
}

}  // namespace

/// By the angle of the principal axis, 2 angle = atan2(2 xy, xx - yy), which the renderer's
/// eigenvector does not use.
Flow flow_from(const glm::dvec4& tensor) {
  const glm::dvec3 t = mean(tensor);
  const double root = std::hypot(t.x - t.z, 2.0 * t.y);
  Flow flow;
  flow.coherence = root / (t.x + t.z + 1e-5);
  if (root == 0.0) return flow;
  const double most = 0.5 * std::atan2(2.0 * t.y, t.x - t.z);
  flow.along = {-std::sin(most), std::cos(most)};
  return flow;
}

Field weighed_colours(const BranchImage& input) {
  Field field(input.size_px);
  for (std::size_t i = 0; i < input.pixels.size(); ++i)
    field.pixels[i] = input.pixels[i].coverage * glm::dvec4(input.pixels[i].colour, 1.0);
  return field;
}

Field blurred_along(const Field& field, glm::ivec2 along, double sigma_px) {
  Field result(field.size_px);
  const int reach = static_cast<int>(std::ceil(2.5 * sigma_px));
  for (int y = 0; y < field.size_px.y; ++y) {
    for (int x = 0; x < field.size_px.x; ++x) {
      double weights = 0.0;
      for (int i = -reach; i <= reach; ++i) {
        const double weight = i == 0 ? 1.0 : std::exp(-0.5 * i * i / (sigma_px * sigma_px));
        const glm::ivec2 there = glm::ivec2(x, y) + i * along;
        weights += weight;
        if (field.contains(there)) result.at({x, y}) += weight * field.at(there);
      }
      result.at({x, y}) /= weights;
    }
  }
  return result;
}

Field blurred(const Field& field, double sigma_px) {
  return blurred_along(blurred_along(field, {1, 0}, sigma_px), {0, 1}, sigma_px);
}

glm::dvec3 mean(const glm::dvec4& weighed) {
  return weighed.a > 0.0 ? glm::dvec3(weighed) / weighed.a : glm::dvec3(0.0);
}

Image<Flow> flow_of(const BranchImage& input, const Field& colours, double smoothing_px) {
  Field tensors(input.size_px);
  for (int y = 0; y < input.size_px.y; ++y) {
    for (int x = 0; x < input.size_px.x; ++x)
      tensors.at({x, y}) = tensor_at(input, colours, {x, y});
  }
  tensors = blurred(tensors, smoothing_px);
  Image<Flow> flow(input.size_px);
  for (std::size_t i = 0; i < flow.pixels.size(); ++i)
    flow.pixels[i] = flow_from(tensors.pixels[i]);
  return flow;
}

}  // namespace cutaway::reference
