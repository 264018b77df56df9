#include "volume/phantom/head_parts.h"

namespace cutaway::phantom {

namespace {

ShapePtr carotid() {
  const ShapePtr common_and_internal = tube({{{24, 4, -180}, 4.2f},
                                             {{26, 2, -130}, 4.2f},
                                             {{28, 0, -92}, 4.6f},
                                             {{27, 6, -66}, 3.2f},
                                             {{28, 8, -40}, 3},
                                             {{28, 8, -18}, 2.9f},
                                             {{20, 2, -8}, 2.8f},
                                             {{13, -6, -4}, 2.7f},
                                             {{13, -14, 4}, 2.6f},
                                             {{12, -22, 9}, 2.6f},
                                             {{11, -16, 15}, 2.5f},
                                             {{12, -8, 20}, 2.5f}});
  const ShapePtr external = tube({{{28, 0, -92}, 3.4f},
                                  {{36, -2, -66}, 2.8f},
                                  {{46, 8, -40}, 2.5f},
                                  {{64, 10, -14}, 2},
                                  {{68, 6, 4}, 1.8f}});
  const ShapePtr facial = tube({{{32, -2, -76}, 1.8f},
                                {{45, -22, -80}, 1.7f},
                                {{45, -42, -68}, 1.6f},
                                {{38, -60, -54}, 1.5f},
                                {{35, -66, -46}, 1.3f}});
  return join(1.5f, {common_and_internal, external, facial});
}

/// Anterior, middle and posterior cerebral arteries with the arcs that join them to a circle.
ShapePtr cerebral() {
  const ShapePtr anterior = tube({{{12, -8, 20}, 2},
                                  {{3, -20, 22}, 1.9f},
                                  {{2.5f, -36, 34}, 1.7f},
                                  {{2.5f, -44, 54}, 1.6f},
                                  {{2.5f, -24, 74}, 1.5f},
                                  {{2.5f, 20, 78}, 1.3f},
                                  {{3, 56, 66}, 1.1f}});
  const ShapePtr middle =
      tube({{{12, -8, 20}, 2.2f}, {{28, -8, 20}, 2}, {{44, -4, 24}, 1.8f}, {{48, 8, 32}, 1.7f}});
  const ShapePtr rising = tube(
      {{{46, -2, 26}, 1.6f}, {{52, -14, 46}, 1.5f}, {{54, -18, 70}, 1.3f}, {{44, -20, 92}, 1.1f}});
  const ShapePtr central =
      tube({{{48, 8, 32}, 1.6f}, {{58, 12, 52}, 1.4f}, {{58, 14, 76}, 1.3f}, {{46, 16, 98}, 1.1f}});
  const ShapePtr parietal =
      tube({{{48, 8, 32}, 1.6f}, {{57, 34, 42}, 1.4f}, {{54, 54, 58}, 1.3f}, {{42, 70, 72}, 1.1f}});
  const ShapePtr posterior = tube({{{0, 8, 16}, 2.1f},
                                   {{10, 6, 18}, 1.9f},
                                   {{20, 20, 18}, 1.8f},
                                   {{20, 42, 22}, 1.6f},
                                   {{12, 66, 32}, 1.4f},
                                   {{8, 80, 44}, 1.1f}});
  const ShapePtr joining = tube({{{12, -8, 19}, 1.3f}, {{11, 0, 17}, 1.2f}, {{10, 6, 18}, 1.3f}});
  return join(1.2f, {anterior, middle, rising, central, parietal, posterior, joining});
}

}  // namespace

ShapePtr head_arteries() {
  const ShapePtr vertebral = tube({{{20, 22, -180}, 2},
                                   {{20, 20, -100}, 2},
                                   {{21, 22, -64}, 2},
                                   {{24, 28, -50}, 2},
                                   {{16, 40, -44}, 2},
                                   {{9, 30, -32}, 2},
                                   {{2, 11, -16}, 2}});
  const ShapePtr basilar = tube({{{0, 9, -18}, 2.3f}, {{0, 3, -4}, 2.3f}, {{0, 8, 16}, 2.2f}});
  const ShapePtr anterior_joint = rod({{{-3, -20, 22}, 1.4f}, {{3, -20, 22}, 1.4f}});
  return join(1,
              {both_sides(join(1, {carotid(), cerebral(), vertebral})), basilar, anterior_joint});
}

ShapePtr head_veins() {
  const ShapePtr sagittal = tube({{{0, -66, 60}, 2.5f},
                                  {{0, -50, 92}, 3},
                                  {{0, 0, 114}, 3.5f},
                                  {{0, 56, 98}, 4},
                                  {{0, 84, 56}, 4.5f},
                                  {{0, 84, 16}, 5}});
  const ShapePtr transverse = tube({{{0, 84, 14}, 4.5f},
                                    {{30, 76, 8}, 4.5f},
                                    {{50, 48, 4}, 4.5f},
                                    {{46, 32, -12}, 4.5f},
                                    {{34, 18, -26}, 5},
                                    {{36, 12, -60}, 6},
                                    {{36, 4, -110}, 6.5f},
                                    {{30, 0, -180}, 7}});
  const ShapePtr below_vault = meet(
      1,
      {both_sides(transverse), join(0, {cranial_vault(11), half_space({0, 0, -16}, {0, 0, 1})})});
  return join(2, {meet(1, {sagittal, cranial_vault(11)}), below_vault});
}

}  // namespace cutaway::phantom
