#include "support/reference_brightness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "support/reference_flow.h"

namespace cutaway::reference {

namespace {

constexpr double kWider = 1.6;
constexpr std::array kNames = {"dog", "xdog", "fdog", "canny", "luminance_quantisation"};

double brightness(glm::dvec3 colour) {
  return glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double gaussian(double offset, double sigma) {
  return std::exp(-0.5 * offset * offset / std::max(sigma * sigma, 1e-6));
}

int wide_reach(double sigma_px) { return static_cast<int>(std::ceil(2.5 * kWider * sigma_px)); }

/// On the same side of the lens' rim, and drawn at all.
bool counts(const BranchImage& input, glm::ivec2 here, glm::ivec2 there) {
  return input.contains(there) && input.at(there).coverage > 0.0 &&
         (input.at(there).behind_lens > 0.5) == (input.at(here).behind_lens > 0.5);
}

/// The brightness under a Gaussian as large as `window` says, of what counts. Along a row what
/// counts is judged from the row's own pixel, as two passes do.
double under(const BranchImage& input, glm::ivec2 at, double sigma_px, int window) {
  double sum = 0.0;
  double weights = 0.0;
  for (int y = -window; y <= window; ++y) {
    const glm::ivec2 row = at + glm::ivec2(0, y);
    const auto side = [&](glm::ivec2 pixel) { return input.at(pixel).behind_lens > 0.5; };
    if (!input.contains(row) || side(row) != side(at)) continue;
    for (int x = -window; x <= window; ++x) {
      const glm::ivec2 there = row + glm::ivec2(x, 0);
      if (!counts(input, row, there)) continue;
      const double weight =
          gaussian(x, sigma_px) * gaussian(y, sigma_px) * input.at(there).coverage;
      sum += weight * brightness(input.at(there).colour);
      weights += weight;
    }
  }
  return sum / std::max(weights, 1e-9);
}

using Levels = Image<double>;

Levels levels(const BranchImage& input, double sigma_px, double wider) {
  Levels result(input.size_px);
  for (int y = 0; y < input.size_px.y; ++y) {
    for (int x = 0; x < input.size_px.x; ++x)
      result.at({x, y}) = under(input, {x, y}, wider * sigma_px, wide_reach(sigma_px));
  }
  return result;
}

glm::dvec2 slope(const BranchImage& input, const Levels& levels, glm::ivec2 at) {
  const auto level = [&](int x, int y) {
    const glm::ivec2 there = glm::clamp(at + glm::ivec2(x, y), glm::ivec2(0), input.size_px - 1);
    return counts(input, at, there) ? levels.at(there) : levels.at(at);
  };
  glm::dvec2 sum(0.0);
  for (const int i : {-1, 0, 1}) {
    const double weight = i == 0 ? 0.25 : 0.125;
    sum += weight * glm::dvec2(level(1, i) - level(-1, i), level(i, 1) - level(i, -1));
  }
  return sum;
}

/// The lines' share of each pixel.
using Ink = Image<double>;

class Lines {
 public:
  Lines(const BranchImage& input, const Json& parameters, double resolution_scale)
      : input_(input), parameters_(parameters), scale_(resolution_scale) {}

  Ink dog() const {
    const double threshold = number("threshold");
    return of_levels([&](double near, double wide) {
      const double darker = number("tau") * wide - near - threshold;
      return std::clamp(darker / std::max(threshold, 0.01), 0.0, 1.0);
    });
  }

  Ink xdog() const {
    return of_levels([&](double near, double wide) {
      const double sharpened = near + number("edges") * (near - wide);
      return std::tanh(number("hardness") * std::max(number("threshold") - sharpened, 0.0));
    });
  }

  Ink fdog() const {
    const Image<Flow> flows = flow();
    Ink across(input_.size_px);
    Ink ink(input_.size_px);
    each_covered([&](glm::ivec2 at) { across.at(at) = difference_across(flows.at(at), at); });
    each_covered([&](glm::ivec2 at) {
      glm::dvec2 sum(across.at(at), 1.0);
      for (const double sign : {1.0, -1.0})
        sum += along(flows, across, at, sign * flows.at(at).along);
      ink.at(at) = std::tanh(number("hardness") * std::max(-sum.x / sum.y, 0.0));
    });
    return ink;
  }

  Ink canny() const {
    Ink edges = crests();
    const auto trail = static_cast<int>(std::lround(number("trail") * scale_));
    for (int i = 0; i < trail; ++i) edges = followed(edges);
    for (double& edge : edges.pixels) edge = edge == 1.0 ? 1.0 : 0.0;
    return edges;
  }

 private:
  double number(const char* name) const { return parameters_.at(name).get<double>(); }
  double sigma_px() const { return number("sigma") * scale_; }

  template <typename Visit>
  void each_covered(Visit&& visit) const {
    for (int y = 0; y < input_.size_px.y; ++y) {
      for (int x = 0; x < input_.size_px.x; ++x)
        if (input_.at({x, y}).coverage > 0.0) visit(glm::ivec2(x, y));
    }
  }

  template <typename Share>
  Ink of_levels(Share&& share) const {
    const Levels near = levels(input_, sigma_px(), 1.0);
    const Levels wide = levels(input_, sigma_px(), kWider);
    Ink ink(input_.size_px);
    each_covered([&](glm::ivec2 at) { ink.at(at) = share(near.at(at), wide.at(at)); });
    return ink;
  }

  Image<Flow> flow() const {
    const Levels near = levels(input_, sigma_px(), 1.0);
    Field tensors(input_.size_px);
    each_covered([&](glm::ivec2 at) {
      const glm::dvec2 s = slope(input_, near, at);
      tensors.at(at) = {s.x * s.x, s.x * s.y, s.y * s.y, 1.0};
    });
    tensors = blurred(tensors, 2.0 * sigma_px());
    Image<Flow> flows(input_.size_px);
    for (std::size_t i = 0; i < flows.pixels.size(); ++i)
      flows.pixels[i] = flow_from(tensors.pixels[i]);
    return flows;
  }

  double difference_across(const Flow& flow, glm::ivec2 at) const {
    const glm::dvec2 across(-flow.along.y, flow.along.x);
    glm::dvec2 near(0.0);
    glm::dvec2 wide(0.0);
    const int reach = wide_reach(sigma_px());
    for (int i = -reach; i <= reach; ++i) {
      const glm::ivec2 there = at + glm::ivec2(glm::floor(double(i) * across + 0.5));
      if (!counts(input_, at, there)) continue;
      const glm::dvec2 level =
          input_.at(there).coverage * glm::dvec2(brightness(input_.at(there).colour), 1.0);
      near += gaussian(i, sigma_px()) * level;
      wide += gaussian(i, kWider * sigma_px()) * level;
    }
    return near.x / near.y - number("tau") * wide.x / wide.y;
  }

  glm::dvec2 along(const Image<Flow>& flows, const Ink& across, glm::ivec2 from,
                   glm::dvec2 way) const {
    const double length_px = number("length") * scale_;
    glm::dvec2 sum(0.0);
    glm::dvec2 at(from);
    for (int i = 1; i <= static_cast<int>(std::ceil(2.0 * length_px)); ++i) {
      at += way;
      const glm::ivec2 there(glm::floor(at + 0.5));
      if (!input_.contains(there) ||
          (input_.at(there).behind_lens > 0.5) != (input_.at(from).behind_lens > 0.5))
        break;
      if (input_.at(there).coverage > 0.0)
        sum += gaussian(i, length_px) * glm::dvec2(across.at(there), 1.0);
      const glm::dvec2 next = flows.at(there).along;
      way = glm::dot(next, way) < 0.0 ? -next : next;
    }
    return sum;
  }

  Ink crests() const {
    const Levels near = levels(input_, sigma_px(), 1.0);
    Levels heights(input_.size_px);
    Ink edges(input_.size_px);
    for (int y = 0; y < input_.size_px.y; ++y) {
      for (int x = 0; x < input_.size_px.x; ++x)
        heights.at({x, y}) =
            std::sqrt(2.0 * M_PI) * sigma_px() * glm::length(slope(input_, near, {x, y}));
    }
    each_covered([&](glm::ivec2 at) {
      const glm::dvec2 s = slope(input_, near, at);
      const double degrees = glm::degrees(std::atan2(s.y, s.x));
      const auto eighth = static_cast<int>(std::lround(degrees / 45.0)) & 3;
      const glm::ivec2 way = std::array{glm::ivec2(1, 0), glm::ivec2(1, 1), glm::ivec2(0, 1),
                                        glm::ivec2(1, -1)}[eighth];
      const double here = heights.at(at);
      const auto before = heights.clamped(at - way);
      const auto after = heights.clamped(at + way);
      if (here <= before || here < after || here == 0.0) return;
      const double high = number("high");
      edges.at(at) = here >= high ? 1.0 : here >= number("low") * high ? 0.5 : 0.0;
    });
    return edges;
  }

  static Ink followed(const Ink& edges) {
    Ink result = edges;
    for (int y = 0; y < edges.size_px.y; ++y) {
      for (int x = 0; x < edges.size_px.x; ++x) {
        if (edges.at({x, y}) == 0.0) continue;
        for (int i = 0; i < 9; ++i)
          result.at({x, y}) =
              std::max(result.at({x, y}), edges.clamped(glm::ivec2(x + i % 3 - 1, y + i / 3 - 1)));
      }
    }
    return result;
  }

  const BranchImage& input_;
  const Json& parameters_;
  double scale_;
};

BranchImage inked(const BranchImage& input, const Ink& ink, const Json& parameters) {
  const auto channels = parameters.at("colour").get<std::vector<double>>();
  const double strength = parameters.at("strength").get<double>();
  BranchImage output = input;
  for (std::size_t i = 0; i < input.pixels.size(); ++i)
    output.pixels[i].colour =
        glm::mix(input.pixels[i].colour, glm::dvec3(channels[0], channels[1], channels[2]),
                 strength * ink.pixels[i]);
  return output;
}

BranchImage quantised(const BranchImage& input, int bins, double hardness) {
  BranchImage output = input;
  for (BranchPixel& pixel : output.pixels) {
    const double before = brightness(pixel.colour);
    const double edge = std::clamp(std::round(before * bins), 1.0, bins - 1.0);
    const double beside = std::tanh(hardness * (before * bins - edge)) / std::tanh(0.5 * hardness);
    const double after = (edge - 0.5 + 0.5 * std::clamp(beside, -1.0, 1.0)) / (bins - 1);
    if (before > 0.0) pixel.colour = glm::clamp(pixel.colour * after / before, 0.0, 1.0);
  }
  return output;
}

}  // namespace

bool draws_from_brightness(const Module& filter) {
  return std::ranges::find(kNames, filter.name) != kNames.end();
}

BranchImage apply_brightness_filter(const BranchImage& input, const Module& filter,
                                    double resolution_scale) {
  const Json& parameters = filter.parameters;
  if (filter.name == "luminance_quantisation")
    return quantised(input, parameters.at("bins").get<int>(),
                     parameters.at("hardness").get<double>());
  if (parameters.at("sigma") == 0) return input;
  const Lines lines(input, parameters, resolution_scale);
  if (filter.name == "dog") return inked(input, lines.dog(), parameters);
  if (filter.name == "xdog") return inked(input, lines.xdog(), parameters);
  if (filter.name == "fdog") return inked(input, lines.fdog(), parameters);
  if (filter.name == "canny") return inked(input, lines.canny(), parameters);
  throw std::logic_error("the reference has no filter " + filter.name);
}

}  // namespace cutaway::reference
