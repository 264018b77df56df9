#include "volume/phantom/spine.h"

namespace cutaway::phantom {

namespace {

ShapePtr body(const VertebraMeasures& m) {
  const glm::vec3 half = m.half_body_mm;
  const glm::vec3 rim{0, 0, half.z - 2.5f};
  const ShapePtr waist = ellipsoid(m.centre_mm, {half.x - 2.5f, half.y - 2, half.z * 1.6f});
  const ShapePtr ends = join(0, {ellipsoid(m.centre_mm + rim, {half.x, half.y, 4}),
                                 ellipsoid(m.centre_mm - rim, {half.x, half.y, 4})});
  const ShapePtr height = meet(1, {half_space(m.centre_mm + glm::vec3(0, 0, half.z), {0, 0, 1}),
                                   half_space(m.centre_mm - glm::vec3(0, 0, half.z), {0, 0, -1})});
  return meet(2, {join(3, {waist, ends}), height});
}

}  // namespace

ShapePtr vertebra(const VertebraMeasures& m) {
  const auto at = [&](float x, float y, float z) { return m.centre_mm + glm::vec3(x, y, z); };
  const float back = m.half_body_mm.y;  // where the canal begins
  const float lamina = back + 19.0f;    // where it ends
  const ShapePtr pedicle = rod({{at(14, back - 4, 5), 5}, {at(15, back + 10, 4), 5}});
  const ShapePtr facet = join(3, {ellipsoid(at(17, back + 13, 14), {5, 6, 9}),
                                  ellipsoid(at(14, back + 16, -13), {5, 5, 9})});
  const ShapePtr arch =
      tube({{at(15, back + 11, 2), 4.4f}, {at(9, back + 17, -1), 4}, {at(0, lamina + 2, -3), 4.2f}},
           {1, 1, 0.55f});
  const ShapePtr transverse =
      rod({{at(15, back + 8, 3), 5}, {at(m.transverse_mm, back + 10, 5), 3.6f}});
  const ShapePtr spinous =
      tube({{at(0, lamina, -3), 3.6f}, {at(0, lamina + m.spinous_mm, -3 - m.spinous_drop_mm), 4}},
           {1, 1, 0.42f});
  return join(3, {body(m), both_sides(join(3, {pedicle, facet, arch, transverse})), spinous});
}

ShapePtr disc(const VertebraMeasures& above, const VertebraMeasures& below) {
  const glm::vec3 half = below.half_body_mm;
  return ellipsoid(0.5f * (above.centre_mm + below.centre_mm), {half.x, half.y, 7.5f});
}

}  // namespace cutaway::phantom
