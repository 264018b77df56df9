#include "volume/phantom/knees_parts.h"

namespace cutaway::phantom {

ShapePtr leg_skin() {
  const ShapePtr leg = tube({{{74, 2, 220}, 68},
                             {{74, 0, 150}, 64},
                             {{72, 1, 100}, 58},
                             {{71, 2, 56}, 51},
                             {{70, 3, 16}, 49},
                             {{70, 7, -30}, 47},
                             {{70, 12, -80}, 50},
                             {{70, 13, -130}, 50},
                             {{70, 12, -220}, 46}});
  const ShapePtr kneecap = ellipsoid({71, -37, 38}, {31, 25.5f, 34});
  const ShapePtr fat_pad =
      join(6, {ellipsoid({58, -33, 5}, {12, 14, 16}), ellipsoid({84, -33, 5}, {12, 14, 16})});
  const ShapePtr tuberosity = ellipsoid({73, -28, -42}, {12, 12, 20});
  const ShapePtr shin = tube({{{73, -24, -50}, 10}, {{71, -22, -100}, 10}, {{69, -19, -200}, 10}});
  const ShapePtr inner =
      join(14, {ellipsoid({40, 2, 26}, {19, 32, 26}), ellipsoid({42, 4, -16}, {18, 26, 22})});
  const ShapePtr outer =
      join(14, {ellipsoid({99, 2, 28}, {19, 30, 26}), ellipsoid({100, 14, -22}, {23, 24, 25})});
  const ShapePtr vastus =
      join(10, {ellipsoid({46, -24, 78}, {19, 20, 32}), ellipsoid({97, -22, 100}, {20, 20, 36})});
  const ShapePtr hamstrings =
      join(4, {tube({{{46, 34, 120}, 22}, {{41, 40, 50}, 11}, {{42, 32, -6}, 9}}),
               tube({{{98, 32, 120}, 22}, {{102, 40, 50}, 11}, {{103, 30, -6}, 9}})});
  const ShapePtr calf =
      join(12, {ellipsoid({52, 40, -88}, {28, 26, 62}), ellipsoid({90, 38, -82}, {26, 24, 56})});
  const ShapePtr whole =
      join(18, {leg, kneecap, fat_pad, tuberosity, shin, inner, outer, vastus, hamstrings, calf});
  const ShapePtr hollow_of_knee = ellipsoid({71, 76, 22}, {20, 20, 44});
  const ShapePtr beside_cap =
      join(4, {ellipsoid({32, -62, 36}, {9, 15, 26}), ellipsoid({110, -60, 36}, {9, 15, 26})});
  return both_sides(carve(10, whole, join(4, {hollow_of_knee, beside_cap})));
}

ShapePtr leg_muscles() {
  const ShapePtr vastus_medialis = tube({{{50, -16, 200}, 28},
                                         {{47, -18, 130}, 26},
                                         {{45, -22, 88}, 21},
                                         {{46, -27, 60}, 11},
                                         {{54, -34, 46}, 4}});
  const ShapePtr vastus_lateralis =
      tube({{{106, -12, 200}, 29}, {{104, -16, 130}, 26}, {{99, -24, 92}, 18}, {{90, -36, 64}, 7}});
  const ShapePtr rectus = tube({{{78, -40, 200}, 17}, {{75, -42, 130}, 13}, {{72, -44, 84}, 6}});
  const ShapePtr intermedius =
      tube({{{78, -22, 200}, 17}, {{75, -22, 130}, 15}, {{72, -26, 84}, 9}});
  const ShapePtr semi = tube({{{50, 36, 200}, 26},
                              {{48, 38, 120}, 23},
                              {{44, 42, 60}, 14},
                              {{42, 36, 6}, 8},
                              {{48, 20, -36}, 4}});
  const ShapePtr biceps = tube({{{98, 34, 200}, 24},
                                {{100, 36, 120}, 21},
                                {{104, 40, 60}, 12},
                                {{108, 32, 4}, 6},
                                {{108, 26, -16}, 4}});
  const ShapePtr adductor = tube({{{58, 16, 200}, 22}, {{56, 14, 130}, 16}, {{42, 8, 56}, 4}});
  const ShapePtr inner_calf = tube({{{47, 36, 40}, 7},
                                    {{48, 44, -4}, 14},
                                    {{50, 46, -60}, 22},
                                    {{52, 44, -120}, 22},
                                    {{58, 40, -200}, 16}},
                                   {0.85f, 1, 1});
  const ShapePtr outer_calf = tube({{{94, 36, 38}, 6},
                                    {{93, 44, -4}, 12},
                                    {{91, 45, -60}, 18},
                                    {{89, 43, -120}, 18},
                                    {{82, 40, -200}, 12}},
                                   {0.85f, 1, 1});
  const ShapePtr soleus =
      tube({{{88, 26, -34}, 8}, {{82, 28, -80}, 16}, {{78, 28, -130}, 19}, {{76, 30, -200}, 17}},
           {0.7f, 1, 1});
  const ShapePtr front =
      tube({{{90, -6, -24}, 7}, {{92, -9, -60}, 13}, {{91, -9, -120}, 14}, {{86, -10, -200}, 11}});
  const ShapePtr peroneal = tube({{{113, 10, -36}, 7}, {{114, 12, -80}, 9}, {{111, 12, -200}, 9}});
  return both_sides(
      join(0.5f, {vastus_medialis, vastus_lateralis, rectus, intermedius, semi, biceps, adductor,
                  inner_calf, outer_calf, soleus, front, peroneal}));
}

ShapePtr knee_ligaments() {
  const ShapePtr quadriceps =
      tube({{{73, -42, 110}, 4}, {{71, -47, 76}, 4.4f}, {{71, -49, 56}, 5}}, {0.4f, 1, 1});
  const ShapePtr patellar =
      tube({{{70, -47, 18}, 4}, {{71, -42, -6}, 3.4f}, {{73, -32, -36}, 3.6f}}, {0.36f, 1, 1});
  const ShapePtr anterior_cruciate = rod({{{79, 16, 20}, 4}, {{67, -4, 0}, 4.4f}});
  const ShapePtr posterior_cruciate = rod({{{62, 6, 16}, 4.6f}, {{71, 27, -8}, 4.6f}});
  const ShapePtr inner_band =
      tube({{{29, 4, 34}, 2.2f}, {{28, 4, 2}, 2.2f}, {{36, 0, -48}, 2.2f}}, {1, 0.3f, 1});
  const ShapePtr outer_band =
      tube({{{112, 4, 34}, 2.4f}, {{115, 14, 6}, 2.4f}, {{111, 24, -16}, 2.4f}});
  return both_sides(join(
      0, {quadriceps, patellar, anterior_cruciate, posterior_cruciate, inner_band, outer_band}));
}

ShapePtr joint_space() {
  const ShapePtr between = ellipsoid({70, 6, 4}, {44, 30, 13});
  const ShapePtr pouch = ellipsoid({71, -34, 62}, {22, 7, 22}, {0, -0.15f, 1});
  return both_sides(join(6, {between, pouch}));
}

ShapePtr leg_arteries() {
  const ShapePtr popliteal = tube({{{56, 20, 200}, 4.4f},
                                   {{60, 26, 120}, 4.4f},
                                   {{68, 34, 60}, 4.2f},
                                   {{71, 36, 10}, 4},
                                   {{73, 32, -34}, 3.6f}});
  const ShapePtr posterior =
      tube({{{73, 32, -34}, 3}, {{74, 24, -70}, 2.8f}, {{66, 22, -200}, 2.4f}});
  const ShapePtr anterior = tube(
      {{{73, 32, -36}, 2.7f}, {{86, 16, -50}, 2.5f}, {{90, 6, -70}, 2.4f}, {{88, 4, -200}, 2.1f}});
  const ShapePtr peroneal =
      tube({{{75, 26, -62}, 2.4f}, {{92, 22, -100}, 2.2f}, {{96, 20, -200}, 2}});
  const ShapePtr genicular =
      join(0, {tube({{{70, 36, 40}, 2}, {{48, 30, 52}, 1.8f}, {{31, 2, 50}, 1.6f}}),
               tube({{{70, 36, 40}, 2}, {{94, 30, 52}, 1.8f}, {{110, 2, 48}, 1.6f}})});
  return both_sides(join(1.5f, {popliteal, posterior, anterior, peroneal, genicular}));
}

ShapePtr leg_veins() {
  const ShapePtr popliteal = tube({{{60, 30, 200}, 5.4f},
                                   {{66, 34, 120}, 5.4f},
                                   {{74, 42, 60}, 5.2f},
                                   {{76, 44, 10}, 5},
                                   {{79, 38, -34}, 4.4f},
                                   {{80, 28, -80}, 3.4f},
                                   {{72, 26, -200}, 3}});
  const ShapePtr saphenous = tube({{{26, 20, 200}, 2.4f},
                                   {{24, 22, 90}, 2.4f},
                                   {{24, 26, 10}, 2.4f},
                                   {{30, 22, -60}, 2.2f},
                                   {{34, 4, -200}, 2}});
  return both_sides(join(2, {popliteal, saphenous}));
}

}  // namespace cutaway::phantom
