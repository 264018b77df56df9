// Kuwahara by sectors of an ellipse; see server/render/filters/anisotropic_kuwahara.frag. The
// weights come from the sources' formulas here, where the shader has them as numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/reference_filters.h"
#include "support/reference_flow.h"

namespace cutaway::reference {

namespace {

constexpr int kSectors = 8;

/// Where the unit disc is looked at, and what share of it that stands for.
struct Place {
  glm::dvec2 at{0.0};
  double area = 0.0;
  std::array<double, kSectors> weights{};
};

/// J. E. Kyprianidis et al. 2010: zeta = 1/3, eta = 3.77; a Gaussian of sigma 0.4.
std::array<double, kSectors> sector_weights(glm::dvec2 at) {
  std::array<double, kSectors> weights{};
  double sum = 0.0;
  for (int i = 0; i < kSectors; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSectors;
    const double x = std::cos(angle) * at.x + std::sin(angle) * at.y;
    const double y = std::cos(angle) * at.y - std::sin(angle) * at.x;
    weights[i] = std::pow(std::max(0.0, x + 1.0 / 3.0 - 3.77 * y * y), 2.0);
    sum += weights[i];
  }
  for (double& weight : weights) weight *= std::exp(-3.125 * glm::dot(at, at)) / sum;
  return weights;
}

void add_ring(std::vector<Place>& places, int count, double radius, double from, double to) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    places.push_back({radius * glm::dvec2(std::cos(angle), std::sin(angle)),
                      (to * to - from * from) / count,
                      {}});
  }
}

std::vector<Place> places() {
  std::vector<Place> places;
  add_ring(places, 1, 0.0, 0.0, 1.0 / 6.0);
  add_ring(places, 8, 1.0 / 3.0, 1.0 / 6.0, 0.5);
  add_ring(places, 16, 2.0 / 3.0, 0.5, 5.0 / 6.0);
  add_ring(places, 16, 0.92, 5.0 / 6.0, 1.0);
  for (Place& place : places) place.weights = sector_weights(place.at);
  return places;
}

struct Sector {
  double all = 0.0;      ///< weights, whether covered or not
  double covered = 0.0;  ///< those of what is there
  glm::dvec3 sum{0.0};
  glm::dvec3 squares{0.0};

  glm::dvec3 mean() const { return sum / std::max(covered, 1e-30); }
  double weight(double sharpness) const {
    const double share = covered / all;
    const glm::dvec3 variance = squares / std::max(covered, 1e-30) - mean() * mean();
    const glm::dvec3 deviation = glm::sqrt(glm::max(variance, glm::dvec3(0.0)));
    const double uneven = 255.0 * (deviation.r + deviation.g + deviation.b);
    const double calm = 1.0 / (1.0 + std::pow(std::max(uneven, 1e-6), sharpness));
    return calm * std::max(share - 0.25, 1e-3 * share);
  }
};

glm::dvec3 sectors_colour(const Field& colours, glm::ivec2 at, glm::dvec2 along, glm::dvec2 across,
                          double sharpness) {
  static const std::vector<Place> all_places = places();
  std::array<Sector, kSectors> sectors;
  for (const Place& place : all_places) {
    const glm::dvec2 offset = place.at.x * along + place.at.y * across;
    const glm::ivec2 there = at + glm::ivec2(glm::floor(offset + 0.5));
    const glm::dvec4 weighed = colours.contains(there) ? colours.at(there) : glm::dvec4(0.0);
    const glm::dvec3 colour = mean(weighed);
    for (int i = 0; i < kSectors; ++i) {
      const double weight = place.area * place.weights[i];
      sectors[i].all += weight;
      sectors[i].covered += weight * weighed.a;
      sectors[i].sum += weight * weighed.a * colour;
      sectors[i].squares += weight * weighed.a * colour * colour;
    }
  }
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (const Sector& sector : sectors) {
    sum += sector.weight(sharpness) * sector.mean();
    weights += sector.weight(sharpness);
  }
  return glm::clamp(sum / weights, 0.0, 1.0);
}

}  // namespace

BranchImage anisotropic_kuwahara(const BranchImage& input, double radius_px, double anisotropy,
                                 double sharpness) {
  BranchImage output = input;
  if (radius_px == 0.0) return output;
  const Field colours = blurred(weighed_colours(input), 0.12 * radius_px);
  const Image<Flow> flows = flow_of(input, colours, radius_px / 3.0);
  for (int y = 0; y < input.size_px.y; ++y) {
    for (int x = 0; x < input.size_px.x; ++x) {
      if (input.at({x, y}).coverage == 0.0) continue;
      const Flow flow = anisotropy > 0.0 ? flows.at({x, y}) : Flow{{1.0, 0.0}, 0.0};
      const double stretch = 1.0 + anisotropy * flow.coherence;
      const glm::dvec2 along = radius_px * stretch * flow.along;
      const glm::dvec2 across = radius_px / stretch * glm::dvec2(-flow.along.y, flow.along.x);
      output.at({x, y}).colour = sectors_colour(colours, {x, y}, along, across, sharpness);
    }
  }
  return output;
}

}  // namespace cutaway::reference
