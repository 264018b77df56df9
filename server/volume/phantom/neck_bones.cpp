#include <array>

#include "volume/phantom/head_parts.h"

namespace cutaway::phantom {

namespace {

struct Vertebra {
  float y_mm;  ///< centre of its body
  float z_mm;
  float spinous_mm;  ///< length of the spinous process
};

constexpr std::array<Vertebra, 5> kBelowAxis{
    {{15, -87, 20}, {14.5f, -104, 21}, {15, -121, 23}, {17, -138, 27}, {20, -155, 32}}};

ShapePtr ring_of(const Vertebra& v) {
  const ShapePtr body = rounded_box({0, v.y_mm, v.z_mm}, {12, 8.5f, 6.2f}, 3);
  const ShapePtr pillar =
      both_sides(rounded_box({18, v.y_mm + 10, v.z_mm}, {6, 6.5f, 8}, 3, {0, -0.5f, 1}));
  const ShapePtr transverse =
      both_sides(rod({{{11, v.y_mm - 1, v.z_mm}, 3.2f}, {{26, v.y_mm + 1, v.z_mm - 2}, 3.4f}}));
  const ShapePtr lamina = both_sides(tube({{{17, v.y_mm + 13, v.z_mm}, 3.4f},
                                           {{9, v.y_mm + 24, v.z_mm - 1}, 3},
                                           {{0, v.y_mm + 28, v.z_mm - 2}, 3.2f}},
                                          {1, 1, 0.7f}));
  const ShapePtr spinous = both_sides(
      rod({{{0, v.y_mm + 28, v.z_mm - 2}, 3}, {{2, v.y_mm + 28 + v.spinous_mm, v.z_mm - 9}, 3}}));
  return join(2.5f, {body, pillar, transverse, lamina, spinous});
}

/// The ring of the first vertebra and the second with its peg.
ShapePtr atlas_and_axis() {
  const ShapePtr mass = both_sides(ellipsoid({19, 24, -49}, {8, 9, 8}));
  const ShapePtr front =
      both_sides(tube({{{0, 7, -50}, 4}, {{12, 12, -50}, 3.6f}, {{19, 22, -50}, 4}}));
  const ShapePtr back = both_sides(
      tube({{{19, 26, -50}, 4}, {{22, 40, -50}, 3.2f}, {{12, 52, -50}, 3.2f}, {{0, 56, -50}, 4}}));
  const ShapePtr wing = both_sides(rod({{{20, 24, -49}, 5}, {{38, 26, -52}, 4}}));
  const ShapePtr peg = rod({{{0, 17, -46}, 4.6f}, {{0, 16, -66}, 6}});
  return join(0, {join(2, {mass, front, back, wing}), join(2, {peg, ring_of({15, -69, 20})})});
}

}  // namespace

ShapePtr cervical_spine() {
  std::vector<ShapePtr> rings{atlas_and_axis()};
  for (const Vertebra& vertebra : kBelowAxis) rings.push_back(ring_of(vertebra));
  return join(0, std::move(rings));
}

ShapePtr spinal_canal() {
  return tube({{{0, 33, -40}, 11},
               {{0, 33, -70}, 8.5f},
               {{0, 33, -104}, 8.5f},
               {{0, 36, -138}, 8.5f},
               {{0, 41, -180}, 8.5f}},
              {0.8f, 1, 1});
}

ShapePtr larynx_cartilage() {
  const ShapePtr thyroid = both_sides(tube(
      {{{0, -24, -110}, 2.2f}, {{9, -16, -110}, 2.2f}, {{17, -2, -108}, 2.2f}}, {1, 1, 0.25f}));
  const ShapePtr cricoid = both_sides(
      tube({{{0, -17, -127}, 2.5f}, {{11, -8, -126}, 2.5f}, {{8, 6, -124}, 3}, {{0, 8, -124}, 3}}));
  return join(0, {thyroid, cricoid});
}

ShapePtr hyoid() {
  return both_sides(tube(
      {{{0, -28, -90}, 3.4f}, {{10, -25, -90}, 3}, {{17, -14, -88}, 2.2f}, {{21, -2, -85}, 1.8f}}));
}

}  // namespace cutaway::phantom
