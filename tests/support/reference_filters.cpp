#include "support/reference_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "support/reference_brightness.h"
#include "support/reference_hatching.h"

namespace cutaway::reference {

namespace {

double brightness(glm::dvec3 colour) {
  return glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
}

struct Statistics {
  glm::dvec3 mean_colour{0.0};
  double variance = 0.0;
  double samples = 0.0;  ///< sum of weights
};

/// The quadrant of the window that reaches from `centre` towards `direction`; pixels weigh as much
/// as they are covered, those outside of the picture nothing.
Statistics quadrant(const BranchImage& input, glm::ivec2 centre, glm::ivec2 direction,
                    int radius_px) {
  Statistics result;
  std::vector<const BranchPixel*> pixels;
  for (int y = 0; y <= radius_px; ++y) {
    for (int x = 0; x <= radius_px; ++x) {
      const glm::ivec2 at = centre + direction * glm::ivec2(x, y);
      if (!input.contains(at) || input.at(at).coverage <= 0.0) continue;
      pixels.push_back(&input.at(at));
      result.samples += input.at(at).coverage;
    }
  }
  double mean_brightness = 0.0;
  for (const BranchPixel* pixel : pixels) {
    result.mean_colour += pixel->colour * pixel->coverage / result.samples;
    mean_brightness += brightness(pixel->colour) * pixel->coverage / result.samples;
  }
  for (const BranchPixel* pixel : pixels) {
    const double offset = brightness(pixel->colour) - mean_brightness;
    result.variance += offset * offset * pixel->coverage / result.samples;
  }
  return result;
}

glm::dvec3 kuwahara_colour(const BranchImage& input, glm::ivec2 centre, int radius_px) {
  std::array<Statistics, 4> quadrants;
  const std::array<glm::ivec2, 4> directions{glm::ivec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}};
  double most = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    quadrants[i] = quadrant(input, centre, directions[i], radius_px);
    most = std::max(most, quadrants[i].samples);
  }
  const double enough = std::min(0.25 * (radius_px + 1) * (radius_px + 1), most);
  double least = 1e9;
  for (const auto& q : quadrants) {
    if (q.samples >= enough) least = std::min(least, q.variance);
  }
  glm::dvec3 sum(0.0);
  int chosen = 0;
  for (const auto& q : quadrants) {
    if (q.samples < enough || q.variance > least + 1e-6) continue;
    sum += q.mean_colour;
    ++chosen;
  }
  return sum / static_cast<double>(chosen);
}

double edge_magnitude(const std::array<double, 9>& n, bool euclidean) {
  const double across = (n[2] + 2.0 * n[5] + n[8]) - (n[0] + 2.0 * n[3] + n[6]);
  const double down = (n[6] + 2.0 * n[7] + n[8]) - (n[0] + 2.0 * n[1] + n[2]);
  return euclidean ? std::hypot(across, down) : std::abs(across) + std::abs(down);
}

glm::dvec3 feature(const BranchPixel& pixel, const Sobel& parameters) {
  const bool is_luma = parameters.source == "luma" ||
                       (parameters.source == "colour" && parameters.mode == "multiply");
  if (is_luma) return glm::dvec3(brightness(pixel.colour));
  if (parameters.source == "depth") return glm::dvec3(pixel.depth_mm / parameters.depth_step_mm);
  return parameters.source == "normal" ? pixel.normal : pixel.colour;
}

/// Edge strength of each colour channel, with the silhouette's put in.
glm::dvec3 edges(const BranchImage& input, glm::ivec2 at, const Sobel& parameters) {
  std::array<std::array<double, 9>, 4> channels{};
  for (int i = 0; i < 9; ++i) {
    const BranchPixel& pixel = input.clamped(at + glm::ivec2(i % 3 - 1, i / 3 - 1));
    const bool is_compared =
        pixel.coverage > 0.0 && std::abs(pixel.behind_lens - input.at(at).behind_lens) <= 0.2;
    const glm::dvec3 value = feature(is_compared ? pixel : input.at(at), parameters);
    for (int c = 0; c < 3; ++c) channels[c][i] = value[c];
    channels[3][i] = parameters.silhouettes ? pixel.silhouette_coverage : 1.0;
  }
  const double gain = parameters.unit_norm ? 0.25 : 1.0;
  const auto edge = [&](int channel) {
    return std::min(1.0, gain * edge_magnitude(channels[channel], parameters.euclidean));
  };
  glm::dvec3 lines(edge(0), edge(1), edge(2));
  if (parameters.source == "depth" || parameters.source == "normal")
    lines = glm::dvec3(std::max({lines.x, lines.y, lines.z}));
  return glm::max(lines, glm::dvec3(edge(3)));
}

}  // namespace

BranchImage kuwahara(const BranchImage& input, int radius_px) {
  BranchImage output = input;
  for (int y = 0; y < input.size_px.y; ++y) {
    for (int x = 0; x < input.size_px.x; ++x) {
      if (input.at({x, y}).coverage > 0.0)
        output.at({x, y}).colour = kuwahara_colour(input, {x, y}, radius_px);
    }
  }
  return output;
}

BranchImage sobel(const BranchImage& input, const Sobel& parameters) {
  BranchImage output = input;
  for (int y = 0; y < input.size_px.y; ++y) {
    for (int x = 0; x < input.size_px.x; ++x) {
      BranchPixel& pixel = output.at({x, y});
      if (pixel.coverage == 0.0) continue;
      const glm::dvec3 lines = edges(input, {x, y}, parameters);
      if (parameters.mode == "darken") pixel.colour -= parameters.strength * lines;
      if (parameters.mode == "brighten") pixel.colour += parameters.strength * lines;
      if (parameters.mode == "multiply")
        pixel.colour *= 1.0 - parameters.strength * brightness(lines);
      pixel.colour = glm::clamp(pixel.colour, 0.0, 1.0);
    }
  }
  return output;
}

BranchImage apply_filter(const BranchImage& input, const Module& filter, double resolution_scale) {
  const Json& parameters = filter.parameters;
  if (filter.name == "kuwahara") {
    const auto radius = parameters.at("radius").get<double>();
    return radius == 0
               ? input
               : kuwahara(input,
                          std::max(1, static_cast<int>(std::lround(radius * resolution_scale))));
  }
  const auto number = [&](const char* name) { return parameters.at(name).get<double>(); };
  if (filter.name == "anisotropic_kuwahara") {
    return anisotropic_kuwahara(input, number("radius") * resolution_scale, number("anisotropy"),
                                number("sharpness"));
  }
  const auto colour = [&](const char* name) {
    const auto channels = parameters.at(name).get<std::vector<double>>();
    return glm::dvec3(channels[0], channels[1], channels[2]);
  };
  if (draws_from_brightness(filter))
    return apply_brightness_filter(input, filter, resolution_scale);
  if (filter.name == "depth_lines") {
    return depth_lines(input, {.strength = number("strength"),
                               .width_px = number("width") * resolution_scale,
                               .ink = colour("colour"),
                               .thinnest = number("thinnest"),
                               .gap_mm = number("gap_mm"),
                               .full_gap_mm = number("full_gap_mm"),
                               .silhouettes = parameters.at("silhouettes").get<bool>()});
  }
  if (filter.name == "hatching") return hatching(input, parameters, resolution_scale);
  if (filter.name == "sobel") {
    return sobel(input, {.strength = parameters.at("strength").get<double>(),
                         .mode = parameters.at("mode").get<std::string>(),
                         .source = parameters.at("source").get<std::string>(),
                         .silhouettes = parameters.at("silhouettes").get<bool>(),
                         .depth_step_mm = parameters.at("depth_step_mm").get<double>(),
                         .unit_norm = parameters.at("norm") == "unit",
                         .euclidean = parameters.at("gradient") == "l2"});
  }
  throw std::logic_error("the reference has no filter " + filter.name);
}

}  // namespace cutaway::reference
