#include "render/tissue_ramp.h"

#include <span>

#include "core/colour.h"

namespace cutaway {

namespace {

struct Stop {
  double value;
  glm::dvec3 colour;
};

/// Hounsfield units: air, lung, fat, muscle, blood, spongy and solid bone.
constexpr std::array kHounsfield = {
    Stop{-1000, {0.09, 0.08, 0.11}}, Stop{-850, {0.30, 0.22, 0.24}}, Stop{-500, {0.56, 0.42, 0.41}},
    Stop{-200, {0.86, 0.71, 0.55}},  Stop{-100, {0.94, 0.84, 0.61}}, Stop{-20, {0.80, 0.55, 0.40}},
    Stop{40, {0.62, 0.24, 0.24}},    Stop{90, {0.73, 0.32, 0.30}},   Stop{170, {0.80, 0.51, 0.44}},
    Stop{300, {0.90, 0.80, 0.66}},   Stop{700, {0.97, 0.93, 0.85}}};
constexpr double kMostHounsfield = 1000.0;

/// Shares of the usual values.
constexpr std::array kOthers = {Stop{0.0, {0.09, 0.08, 0.11}},  Stop{0.15, {0.36, 0.22, 0.24}},
                                Stop{0.4, {0.62, 0.27, 0.27}},  Stop{0.65, {0.82, 0.55, 0.42}},
                                Stop{0.85, {0.94, 0.84, 0.61}}, Stop{1.0, {0.97, 0.93, 0.85}}};

glm::dvec3 colour_at(std::span<const Stop> stops, double value) {
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (value >= stops[i].value) continue;
    const double width = stops[i].value - stops[i - 1].value;
    return mix_colours(stops[i - 1].colour, stops[i].colour, (value - stops[i - 1].value) / width);
  }
  return stops.back().colour;
}

}  // namespace

TissueRamp tissue_ramp(const LoadedVolume& loaded) {
  const bool is_hounsfield = loaded.volume.description.units == "HU";
  const ValueRange usual = loaded.histogram.range;
  TissueRamp ramp;
  ramp.range = is_hounsfield ? ValueRange{kHounsfield.front().value, kMostHounsfield} : usual;
  for (int i = 0; i < kTissueColours; ++i) {
    const double share = double(i) / (kTissueColours - 1);
    const double value = glm::mix(ramp.range.minimum, ramp.range.maximum, share);
    ramp.colours[i] = is_hounsfield ? colour_at(kHounsfield, value) : colour_at(kOthers, share);
  }
  return ramp;
}

}  // namespace cutaway
