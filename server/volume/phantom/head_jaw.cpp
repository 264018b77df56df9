#include <array>

#include "volume/phantom/head_parts.h"

namespace cutaway::phantom {

namespace {

struct Tooth {
  float x_mm;
  float y_mm;
  float half_width_mm;  ///< along the arch
  float half_depth_mm;  ///< across it
  float root_mm;        ///< its length
};

constexpr std::array<Tooth, 8> kUpperTeeth{{{4.4f, -88.5f, 4.2f, 3.2f, 12},
                                            {12.2f, -86, 3.4f, 3, 12},
                                            {18.6f, -81, 3.8f, 3.8f, 15},
                                            {23, -74, 3.5f, 4.4f, 12},
                                            {25.8f, -67, 3.5f, 4.5f, 12},
                                            {28.2f, -58, 5, 5.4f, 11},
                                            {30, -48, 4.8f, 5.3f, 11},
                                            {31, -38.5f, 4.4f, 5, 10}}};

constexpr std::array<Tooth, 8> kLowerTeeth{{{2.8f, -85.5f, 2.7f, 2.8f, 11},
                                            {8.6f, -84.5f, 3, 2.9f, 12},
                                            {15.2f, -81, 3.5f, 3.6f, 14},
                                            {20.4f, -75, 3.5f, 3.8f, 12},
                                            {24, -68, 3.6f, 4, 12},
                                            {27, -58.5f, 5.4f, 5, 12},
                                            {29.4f, -47.5f, 5.2f, 5, 12},
                                            {31, -37.5f, 5, 4.8f, 11}}};

constexpr float kOcclusionMm = -54.5f;  ///< z of the plane where the rows meet
constexpr float kCrownMm = 9.0f;

/// Boxes are axis-aligned; between the incisors, which face forward, and the molars, which face
/// sideways, width and depth exchange their axes.
glm::vec3 half_size(const Tooth& tooth, float half_height_mm) {
  const float sideways = glm::clamp((tooth.y_mm + 86.0f) / 14.0f, 0.0f, 1.0f);
  const float x = tooth.half_width_mm + sideways * (tooth.half_depth_mm - tooth.half_width_mm);
  const float y = tooth.half_depth_mm + sideways * (tooth.half_width_mm - tooth.half_depth_mm);
  return {x - 0.35f, y - 0.35f, half_height_mm};
}

std::vector<ShapePtr> crowns(const std::array<Tooth, 8>& teeth, float up) {
  std::vector<ShapePtr> shapes;
  for (const Tooth& tooth : teeth) {
    const glm::vec3 centre(tooth.x_mm, tooth.y_mm, kOcclusionMm + up * 0.5f * kCrownMm);
    shapes.push_back(both_sides(rounded_box(centre, half_size(tooth, 0.5f * kCrownMm - 0.3f), 2)));
  }
  return shapes;
}

std::vector<ShapePtr> roots(const std::array<Tooth, 8>& teeth, float up) {
  std::vector<ShapePtr> shapes;
  for (const Tooth& tooth : teeth) {
    const float neck = kOcclusionMm + up * (kCrownMm - 1.5f);
    shapes.push_back(
        both_sides(rod({{{tooth.x_mm, tooth.y_mm + 1.5f, neck}, 2.3f},
                        {{tooth.x_mm, tooth.y_mm + 5, neck + up * tooth.root_mm}, 1.2f}})));
  }
  return shapes;
}

ShapePtr both_rows(std::vector<ShapePtr> upper, const std::vector<ShapePtr>& lower) {
  upper.insert(upper.end(), lower.begin(), lower.end());
  return join(0, std::move(upper));
}

}  // namespace

ShapePtr mandible() {
  const ShapePtr condyle = ellipsoid({54, 5, -6}, {9, 4.5f, 5});
  const ShapePtr neck = rod({{{54, 4, -8}, 4}, {{52, -2, -24}, 5}});
  const ShapePtr ramus =
      tube({{{52, -9, -26}, 4.2f}, {{51, -13, -42}, 4.8f}, {{48, -14, -62}, 5.2f}}, {1, 0.3f, 1});
  const ShapePtr coronoid = rod({{{50, -25, -12}, 2.4f}, {{50, -20, -32}, 5}});
  const ShapePtr body = tube({{{47, -8, -66}, 6},
                              {{40, -34, -74}, 6.2f},
                              {{28, -60, -80}, 6.4f},
                              {{14, -75, -83}, 6.6f},
                              {{0, -79, -83}, 6.8f}},
                             {1, 1, 0.62f});
  const ShapePtr sockets = tube({{{30, -34, -66}, 5.5f},
                                 {{26, -58, -69}, 5.5f},
                                 {{18, -75, -71}, 5},
                                 {{7, -82, -71}, 4.6f},
                                 {{0, -83, -71}, 4.6f}});
  const ShapePtr chin = ellipsoid({0, -82, -90}, {14, 6, 6});
  return both_sides(join(5, {condyle, neck, ramus, coronoid, body, sockets, chin}));
}

ShapePtr tooth_crowns() { return both_rows(crowns(kUpperTeeth, 1), crowns(kLowerTeeth, -1)); }

ShapePtr tooth_roots() { return both_rows(roots(kUpperTeeth, 1), roots(kLowerTeeth, -1)); }

}  // namespace cutaway::phantom
