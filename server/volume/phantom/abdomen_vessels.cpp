#include "volume/phantom/abdomen_parts.h"

namespace cutaway::phantom {

namespace {

/// Out of the pelvis to the thigh, and back to the pelvic organs and buttocks.
ShapePtr iliac() {
  const ShapePtr outer = tube({{{1, 6, -20}, 7.5f},
                               {{18, 10, -50}, 6.5f},
                               {{38, 12, -78}, 6},
                               {{58, -12, -108}, 5.4f},
                               {{72, -40, -136}, 5.2f},
                               {{78, -46, -164}, 5},
                               {{86, -36, -260}, 4.6f}});
  const ShapePtr inner = tube(
      {{{36, 12, -76}, 4.4f}, {{40, 34, -96}, 4}, {{42, 54, -124}, 3.2f}, {{58, 66, -150}, 2.6f}});
  const ShapePtr deep =
      tube({{{79, -46, -166}, 3.6f}, {{96, -30, -190}, 3.2f}, {{104, -16, -260}, 2.8f}});
  return join(2, {outer, inner, deep});
}

ShapePtr visceral() {
  const ShapePtr coeliac =
      tube({{{4, 14, 106}, 4.4f}, {{3, -4, 108}, 4.2f}, {{2, -10, 106}, 3.8f}});
  const ShapePtr hepatic = tube(
      {{{2, -10, 106}, 3.4f}, {{-20, -14, 98}, 3}, {{-38, -14, 104}, 2.6f}, {{-62, -8, 118}, 2}});
  const ShapePtr splenic = tube({{{2, -10, 106}, 3.6f},
                                 {{24, -2, 112}, 3.2f},
                                 {{40, 14, 104}, 3.2f},
                                 {{56, 12, 116}, 3},
                                 {{72, 20, 110}, 3},
                                 {{88, 22, 118}, 2.4f}});
  const ShapePtr mesenteric = tube({{{4, 12, 90}, 4.6f},
                                    {{3, -8, 82}, 4.4f},
                                    {{0, -20, 60}, 4.2f},
                                    {{-6, -24, 20}, 3.8f},
                                    {{-22, -26, -20}, 3},
                                    {{-48, -14, -56}, 2.4f}});
  const ShapePtr to_left_loops =
      join(1, {tube({{{0, -20, 56}, 2.6f}, {{24, -30, 30}, 2.3f}, {{48, -34, 12}, 2}}),
               tube({{{-2, -23, 34}, 2.6f}, {{22, -32, 0}, 2.2f}, {{42, -32, -30}, 2}}),
               tube({{{-8, -24, 12}, 2.5f}, {{6, -34, -26}, 2.2f}, {{22, -32, -64}, 2}})});
  const ShapePtr to_colon =
      tube({{{-3, -22, 40}, 2.6f}, {{-40, -22, 36}, 2.3f}, {{-74, -4, 20}, 2}});
  const ShapePtr lower =
      tube({{{3, 4, 22}, 3}, {{18, 0, -6}, 2.7f}, {{40, 10, -44}, 2.3f}, {{34, 10, -84}, 2}});
  return join(1.5f, {coeliac, hepatic, splenic, mesenteric, to_left_loops, to_colon, lower});
}

ShapePtr renal() {
  const ShapePtr left =
      tube({{{8, 14, 76}, 4}, {{28, 26, 72}, 3.6f}, {{48, 40, 68}, 3.2f}, {{60, 44, 82}, 2.2f}});
  const ShapePtr left_lower = tube({{{46, 39, 68}, 2.6f}, {{60, 46, 54}, 2.2f}});
  const ShapePtr right = tube(
      {{{-2, 14, 72}, 4}, {{-24, 28, 62}, 3.6f}, {{-46, 40, 54}, 3.2f}, {{-58, 44, 66}, 2.2f}});
  const ShapePtr right_lower = tube({{{-44, 39, 54}, 2.6f}, {{-58, 46, 38}, 2.2f}});
  return join(1.5f, {left, left_lower, right, right_lower});
}

}  // namespace

ShapePtr abdomen_arteries() {
  const ShapePtr aorta = tube({{{10, 30, 280}, 12.5f},
                               {{9, 30, 200}, 12},
                               {{6, 20, 130}, 11.5f},
                               {{4, 14, 80}, 10.5f},
                               {{3, 8, 30}, 9.5f},
                               {{1, 8, -20}, 9}});
  const ShapePtr lumbar =
      both_sides(join(0, {tube({{{5, 12, 60}, 2.2f}, {{24, 22, 58}, 2}, {{32, 44, 56}, 2}}),
                          tube({{{4, 10, 24}, 2.2f}, {{24, 18, 21}, 2}, {{34, 40, 19}, 2}}),
                          tube({{{3, 10, -8}, 2.2f}, {{24, 20, -12}, 2}, {{35, 42, -14}, 2}})}));
  return join(3, {aorta, both_sides(iliac()), visceral(), renal(), lumbar});
}

ShapePtr abdomen_veins() {
  const ShapePtr cava =
      tube({{{-22, 4, 190}, 13}, {{-22, 12, 130}, 13}, {{-22, 14, 60}, 12}, {{-20, 12, -20}, 11}},
           {0.85f, 1, 1});
  const ShapePtr iliac_veins = join(2, {tube({{{-20, 12, -22}, 9},
                                              {{-36, 22, -76}, 8},
                                              {{-62, -2, -112}, 7.5f},
                                              {{-66, -38, -150}, 7},
                                              {{-72, -36, -260}, 6.5f}}),
                                        tube({{{-20, 12, -22}, 9},
                                              {{8, 22, -56}, 8},
                                              {{36, 24, -80}, 8},
                                              {{60, -2, -112}, 7.5f},
                                              {{64, -38, -150}, 7},
                                              {{70, -36, -260}, 6.5f}})});
  const ShapePtr renal_veins = join(
      2, {tube({{{-20, 12, 70}, 5}, {{8, 2, 74}, 4.6f}, {{34, 22, 72}, 5}, {{56, 38, 70}, 4.5f}}),
          tube({{{-26, 14, 56}, 5}, {{-52, 36, 52}, 4.5f}})});
  const ShapePtr hepatic =
      join(2, {tube({{{-24, 6, 166}, 6}, {{-56, 4, 158}, 4.5f}, {{-90, 10, 136}, 3}}),
               tube({{{-22, 2, 166}, 6}, {{-44, -24, 152}, 4.4f}, {{-66, -42, 122}, 3}}),
               tube({{{-20, 0, 164}, 5}, {{0, -28, 150}, 4}, {{20, -42, 136}, 3}})});
  return join(3, {cava, iliac_veins, renal_veins, hepatic});
}

ShapePtr portal_vein() {
  const ShapePtr trunk = tube({{{-6, -14, 62}, 6.5f},
                               {{-18, -12, 84}, 7},
                               {{-36, -8, 106}, 6.5f},
                               {{-62, 2, 112}, 5},
                               {{-90, 4, 102}, 3.5f}});
  const ShapePtr left =
      tube({{{-36, -8, 106}, 5}, {{-18, -30, 122}, 4.5f}, {{10, -44, 128}, 3.4f}});
  const ShapePtr splenic = tube({{{-6, -14, 64}, 5.5f}, {{30, -2, 88}, 5}, {{70, 22, 104}, 4.4f}});
  const ShapePtr mesenteric =
      tube({{{-6, -14, 62}, 6}, {{-10, -20, 20}, 5.5f}, {{-24, -20, -20}, 4}});
  return join(3, {trunk, left, splenic, mesenteric});
}

}  // namespace cutaway::phantom
