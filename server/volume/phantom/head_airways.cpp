#include "volume/phantom/head_parts.h"

namespace cutaway::phantom {

ShapePtr sinuses() {
  const ShapePtr maxillary = both_sides(ellipsoid({27, -55, -20}, {10.5f, 14, 12.5f}));
  const ShapePtr sphenoid = both_sides(ellipsoid({7, -26, 3}, {7, 11, 8}));
  const ShapePtr ethmoid =
      both_sides(join(0, {sphere({6, -66, 10}, 3.6f), sphere({6, -57, 12}, 3.6f),
                          sphere({6, -48, 11}, 3.6f), sphere({6, -40, 9}, 3.6f)}));
  const ShapePtr left_frontal = ellipsoid({10, -71, 33}, {8, 3.5f, 8});
  const ShapePtr right_frontal = ellipsoid({-7, -71, 30}, {5, 3, 5});
  const ShapePtr mastoid = both_sides(
      join(0, {sphere({55, 22, -8}, 4), sphere({54, 27, -14}, 3.6f), sphere({55, 21, -19}, 3.2f),
               sphere({56, 27, -3}, 3.2f), sphere({55, 22, -26}, 2.4f)}));
  return join(1, {maxillary, sphenoid, ethmoid, left_frontal, right_frontal, mastoid});
}

ShapePtr nasal_cavity() {
  const ShapePtr lower = rounded_box({0, -53, -22}, {12.5f, 31, 10}, 7);
  const ShapePtr upper = rounded_box({0, -55, -4}, {6, 27, 12}, 5);
  return join(6, {lower, upper});
}

ShapePtr nasal_walls() {
  const ShapePtr septum = rounded_box({0, -62, -10}, {1.3f, 40, 26}, 1);
  const ShapePtr inferior =
      tube({{{9, -80, -25}, 2.5f}, {{8, -60, -25}, 3.6f}, {{8.5f, -36, -24}, 3}});
  const ShapePtr middle = tube({{{7, -72, -11}, 2}, {{6, -55, -11}, 3}, {{7, -38, -12}, 2}});
  const ShapePtr walls = join(1, {septum, both_sides(inferior), both_sides(middle)});
  return meet(0, {walls, nasal_cavity()});
}

ShapePtr nostrils() {
  return both_sides(tube({{{6.5f, -100, -36}, 3.4f}, {{6, -98, -28}, 4}, {{6, -88, -20}, 4.5f}}));
}

ShapePtr throat() {
  const ShapePtr pharynx = tube({{{0, -26, -18}, 7},
                                 {{0, -12, -26}, 7},
                                 {{0, -4, -48}, 6},
                                 {{0, -6, -72}, 7},
                                 {{0, -8, -96}, 6}},
                                {0.7f, 1, 1});
  const ShapePtr trachea =
      tube({{{0, -8, -94}, 6}, {{0, -9, -110}, 5}, {{0, -5, -126}, 8}, {{0, 0, -170}, 8.5f}});
  const ShapePtr mouth = ellipsoid({0, -50, -43}, {15, 24, 2.4f});
  return join(3, {pharynx, trachea, mouth});
}

ShapePtr ear_canals() {
  return both_sides(tube({{{82, 11, 0}, 3.4f}, {{66, 9, 1}, 3}, {{44, 8, 2}, 3.4f}}));
}

}  // namespace cutaway::phantom
