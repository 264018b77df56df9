#include <array>

#include "volume/phantom/abdomen_parts.h"
#include "volume/phantom/spine.h"

namespace cutaway::phantom {

namespace {

const std::array<VertebraMeasures, 10>& vertebrae() {
  static const std::array<VertebraMeasures, 10> measures{{
      {{0, 47, -60}, {26, 18, 13}, 14, 4, 40},
      {{0, 36, -24}, {26, 18, 13.5f}, 22, 5, 42},
      {{0, 31, 13}, {25.5f, 17.5f, 13.5f}, 25, 6, 46},
      {{0, 32, 50}, {25, 17, 13.5f}, 25, 6, 44},
      {{0, 37, 86}, {24, 17, 13}, 22, 6, 38},
      {{0, 42, 120}, {23, 16.5f, 12.5f}, 19, 8, 27},
      {{0, 46, 152}, {22, 16, 12}, 18, 14, 27},
      {{0, 49, 183}, {21, 16, 11.5f}, 18, 18, 30},
      {{0, 50, 213}, {20, 15.5f, 11}, 18, 20, 31},
      {{0, 50, 242}, {19, 15, 11}, 18, 22, 32},
  }};
  return measures;
}

/// The course of ribs round the chest: sine and cosine of the angle from the back, in steps of 20
/// degrees.
struct Heading {
  float sine;
  float cosine;
};
constexpr std::array<Heading, 8> kHeadings{{{0.342f, 0.940f},
                                            {0.643f, 0.766f},
                                            {0.866f, 0.5f},
                                            {0.985f, 0.174f},
                                            {0.985f, -0.174f},
                                            {0.866f, -0.5f},
                                            {0.643f, -0.766f},
                                            {0.342f, -0.940f}}};

struct Rib {
  float z_mm;     ///< at the spine
  float y_mm;     ///< of the vertebra's joint
  float drop_mm;  ///< how far the front end lies below the spine
  int headings;   ///< how far round it is bone
  float breadth;  ///< of the chest there, as a share of the widest
};

/// The twelfth to the fifth.
constexpr std::array<Rib, 8> kRibs{{{124, 58, 60, 2, 0.97f},
                                    {157, 62, 100, 4, 0.98f},
                                    {188, 64, 124, 6, 0.99f},
                                    {217, 66, 128, 6, 1.0f},
                                    {246, 67, 128, 6, 0.99f},
                                    {275, 67, 124, 6, 0.97f},
                                    {303, 66, 118, 7, 0.94f},
                                    {330, 64, 112, 7, 0.9f}}};

glm::vec3 on_chest(const Rib& rib, int heading) {
  const Heading& h = kHeadings[heading];
  const float fall = float(heading + 1) / float(kHeadings.size());
  return {131 * rib.breadth * h.sine, 4 + 89 * rib.breadth * h.cosine,
          rib.z_mm - rib.drop_mm * fall * fall * (1.6f - 0.6f * fall)};
}

ShapePtr rib_shape(const Rib& rib) {
  std::vector<Knot> knots{{{20, rib.y_mm, rib.z_mm + 2}, 4}};
  for (int i = 0; i < rib.headings; ++i) {
    knots.push_back({on_chest(rib, i), i + 1 == rib.headings ? 2.8f : 3.5f});
  }
  return tube(knots, {1, 1, 0.55f});
}

}  // namespace

ShapePtr lumbar_spine() {
  std::vector<ShapePtr> parts;
  parts.reserve(vertebrae().size());
  for (const VertebraMeasures& measures : vertebrae()) parts.push_back(vertebra(measures));
  return join(0, std::move(parts));
}

ShapePtr discs() {
  std::vector<ShapePtr> parts;
  for (std::size_t i = 1; i < vertebrae().size(); ++i) {
    parts.push_back(disc(vertebrae()[i], vertebrae()[i - 1]));
  }
  parts.push_back(ellipsoid({0, 51, -78}, {25, 18, 6}, {0, 0.5f, 1}));
  return join(0, std::move(parts));
}

ShapePtr ribs() {
  std::vector<ShapePtr> parts;
  parts.reserve(kRibs.size());
  for (const Rib& rib : kRibs) parts.push_back(rib_shape(rib));
  return join(0,
              {both_sides(join(0, std::move(parts))),
               tube({{{0, -88, 300}, 7}, {{0, -90, 214}, 6}, {{0, -86, 178}, 3}}, {0.45f, 1, 1})});
}

/// The front ends of the seventh to tenth rib, running up to the breastbone.
ShapePtr rib_cartilage() {
  std::vector<ShapePtr> parts;
  for (const Rib& rib : kRibs) {
    if (rib.headings < 6) continue;
    const glm::vec3 end = on_chest(rib, rib.headings - 1);
    parts.push_back(tube({{end, 4},
                          {on_chest(rib, 6) + glm::vec3(0, 0, 14), 4},
                          {{16, -88, glm::max(196.0f, end.z + 40)}, 4}},
                         {1, 1, 0.7f}));
  }
  return both_sides(join(2, std::move(parts)));
}

}  // namespace cutaway::phantom
