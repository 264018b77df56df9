// Strokes of ink: each pixel walks its own way and sums the noise that it meets.
#include "support/reference_hatching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "support/reference_flow.h"

namespace cutaway::reference {

namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr double kCrossedBy = 1.134;

std::uint32_t scrambled(std::uint32_t state) {
  state = state * 747796405U + 2891336453U;
  const std::uint32_t word = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
  return (word >> 22U) ^ word;
}

/// A lattice point's wavelet.
struct Wavelet {
  double height;
  double phase;
  double way;

  Wavelet(glm::ivec2 cell, int family) {
    const auto x = static_cast<std::uint32_t>(cell.x);
    const auto y = static_cast<std::uint32_t>(cell.y);
    const std::uint32_t bits =
        scrambled(x + scrambled(y + scrambled(static_cast<std::uint32_t>(family))));
    const auto share = [&](int from) { return (((bits >> from) & 1023U) + 0.5) / 1024.0; };
    height = std::sqrt(-2.0 * std::log(share(0)));
    phase = share(10);
    way = kTurn * share(20);
  }
};

/// `waves`: how many waves a wavelet has gone through at an offset from its point.
template <typename Waves>
double noise(glm::dvec2 at, int family, Waves&& waves) {
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 cell = glm::ivec2(glm::floor(at)) + glm::ivec2(i % 2, i / 2);
    const glm::dvec2 offset = at - glm::dvec2(cell);
    const Wavelet wavelet(cell, family);
    sum += std::cos(M_PI_2 * offset.x) * std::cos(M_PI_2 * offset.y) * wavelet.height *
           std::cos(kTurn * (waves(wavelet, offset) + wavelet.phase));
  }
  return sum;
}

double normal_below(double share) {
  double low = -6.0;
  double high = 6.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / M_SQRT2) < share ? low : high) = middle;
  }
  return low;
}

double both(double first, double second) { return first + second - first * second; }

class Hatching {
 public:
  Hatching(const BranchImage& input, const Json& parameters, double resolution_scale)
      : input_(input),
        parameters_(parameters),
        width_px_(number("width") * resolution_scale),
        length_px_(std::max(number("length") * resolution_scale, 2.0 * width_px_)),
        angle_(glm::radians(number("angle_degrees"))),
        flows_(input.size_px) {
    const double apart_px = std::max(0.6 * width_px_, 1.0);
    samples_ = std::clamp(static_cast<int>(std::ceil(0.5 * length_px_ / apart_px)), 1, 32);
    step_px_ = 0.5 * length_px_ / samples_;
    follows_ = parameters.at("direction") == "curvature";
    if (!follows_ || width_px_ == 0.0) return;
    deviation_ = deviation();
    find_flows();
  }

  BranchImage drawn() const {
    BranchImage output = input_;
    if (width_px_ == 0.0) return output;
    for (int y = 0; y < input_.size_px.y; ++y) {
      for (int x = 0; x < input_.size_px.x; ++x) {
        BranchPixel& pixel = output.at({x, y});
        if (pixel.coverage == 0.0) continue;
        const glm::dvec3 ground = glm::mix(colour("paper"), pixel.colour, number("wash"));
        pixel.colour = glm::mix(pixel.colour, glm::mix(ground, colour("ink"), ink_at({x, y})),
                                number("strength"));
      }
    }
    return output;
  }

 private:
  double number(const char* name) const { return parameters_.at(name).get<double>(); }
  glm::dvec3 colour(const char* name) const {
    const auto channels = parameters_.at(name).get<std::vector<double>>();
    return {channels[0], channels[1], channels[2]};
  }

  double ink_at(glm::ivec2 at) const {
    const double darkness =
        1.0 - glm::dot(input_.at(at).colour, glm::dvec3(0.2126, 0.7152, 0.0722));
    if (input_.at(at).behind_lens > 0.5) {
      const double darker = darkness + (1.0 - darkness) * number("wall_darker");
      const double each = 1.0 - std::sqrt(1.0 - std::min(darker, 1.0));
      return both(inked(parallel(at, angle_ + 0.611, 1), each),
                  inked(parallel(at, angle_ - 0.524, 2), each));
    }
    const double first = std::min(darkness, number("cross_from"));
    const double second = darkness <= first ? 0.0 : (darkness - first) / (1.0 - first);
    return both(inked(strokes(at, 0.0, 1), first), inked(strokes(at, kCrossedBy, 2), second));
  }

  double strokes(glm::ivec2 at, double by, int family) const {
    return follows_ ? curved(at, by, family) : parallel(at, angle_ + by, family);
  }

  double inked(double noise, double share) const {
    if (share <= 0.0 || share >= 1.0) return share <= 0.0 ? 0.0 : 1.0;
    const double edge = 1.2 * M_PI / width_px_;
    const double limit = normal_below(share) * std::sqrt(1.0 + edge * edge / 12.0);
    return std::clamp(0.5 + (limit - noise) / edge, 0.0, 1.0);
  }

  double parallel(glm::ivec2 at, double angle, int family) const {
    const glm::dvec2 place = glm::dvec2(at) + 0.5;
    const glm::dvec2 along(std::cos(angle), -std::sin(angle));
    const glm::dvec2 across(-along.y, along.x);
    return noise(
        {glm::dot(place, along) / (0.6 * length_px_), glm::dot(place, across) / (2.0 * width_px_)},
        family, [](const Wavelet&, glm::dvec2 offset) { return offset.y; });
  }

  double isotropic(glm::dvec2 at, int family) const {
    const glm::ivec2 last = input_.size_px - 1;
    glm::ivec2 there = glm::abs(glm::ivec2(glm::floor(at)));
    there = glm::clamp(last - glm::abs(last - there), glm::ivec2(0), last);
    return noise((glm::dvec2(there) + 0.5) / (2.0 * width_px_), family,
                 [](const Wavelet& wavelet, glm::dvec2 offset) {
                   return glm::dot(offset,
                                   glm::dvec2(std::cos(wavelet.way), std::sin(wavelet.way)));
                 });
  }

  double weight(int i) const { return std::pow(std::cos(M_PI_2 * i / (samples_ + 1)), 2.0); }

  double curved(glm::ivec2 at, double by, int family) const {
    const glm::dvec2 from = glm::dvec2(at) + 0.5;
    double sum = isotropic(from, family);
    for (const double sign : {1.0, -1.0}) {
      glm::dvec2 way = sign * turned(flows_.at(at), by);
      glm::dvec2 place = from;
      for (int i = 1; i <= samples_; ++i) {
        place += step_px_ * way;
        sum += weight(i) * isotropic(place, family);
        way = next_way(place, way, by);
      }
    }
    return sum / deviation_;
  }

  glm::dvec2 next_way(glm::dvec2 place, glm::dvec2 way, double by) const {
    const glm::ivec2 at = glm::clamp(glm::ivec2(place), glm::ivec2(0), input_.size_px - 1);
    if (!is_form(at)) return way;
    const glm::dvec2 next = turned(flows_.at(at), by);
    const double along = glm::dot(next, way);
    if (std::abs(along) <= 0.5) return way;
    return along < 0.0 ? -next : next;
  }

  static glm::dvec2 turned(glm::dvec2 way, double by) {
    return {std::cos(by) * way.x - std::sin(by) * way.y,
            std::sin(by) * way.x + std::cos(by) * way.y};
  }

  /// Of the weighted sum along a straight way: of windows half a cosine long and waves of all ways.
  double deviation() const {
    constexpr int kSteps = 200;
    const auto correlation = [&](double apart) {
      double windows = 0.0;
      double waves = 0.0;
      for (int i = 0; i < kSteps; ++i) {
        const double x = -1.0 + 2.0 * (i + 0.5) / kSteps;
        if (x + apart < 1.0)
          windows += 2.0 / kSteps * std::cos(M_PI_2 * x) * std::cos(M_PI_2 * (x + apart));
        waves += std::cos(kTurn * apart * std::cos(kTurn * (i + 0.5) / kSteps)) / kSteps;
      }
      return windows * waves;
    };
    double variance = 0.0;
    for (int apart = 0; apart <= 2 * samples_; ++apart) {
      double weights = 0.0;
      for (int i = -samples_; i + apart <= samples_; ++i) weights += weight(i) * weight(i + apart);
      variance +=
          (apart == 0 ? 1.0 : 2.0) * weights * correlation(apart * step_px_ / (2.0 * width_px_));
    }
    return std::sqrt(variance);
  }

  bool is_form(glm::ivec2 at) const {
    const BranchPixel& pixel = input_.at(at);
    return pixel.coverage > 0.0 && pixel.behind_lens <= 0.5;
  }

  glm::dvec3 turn(glm::ivec2 at, glm::ivec2 along) const {
    glm::dvec3 sum(0.0);
    int sides = 0;
    for (const int side : {-1, 1}) {
      const glm::ivec2 there = at + side * along;
      if (!input_.contains(there) || !is_form(there)) continue;
      const glm::dvec3 turned = input_.at(there).seen_normal - input_.at(at).seen_normal;
      if (glm::dot(turned, turned) >= 0.35) continue;
      sum += double(side) * turned;
      ++sides;
    }
    return sum / std::max(double(sides), 1.0);
  }

  void find_flows() {
    Field turning(input_.size_px);
    for (int y = 0; y < input_.size_px.y; ++y) {
      for (int x = 0; x < input_.size_px.x; ++x) {
        if (!is_form({x, y})) continue;
        const glm::dvec3 across = turn({x, y}, {1, 0});
        const glm::dvec3 down = turn({x, y}, {0, 1});
        turning.at({x, y}) = {glm::dot(across, across), glm::dot(across, down),
                              glm::dot(down, down), 1.0};
      }
    }
    turning = blurred(turning, 0.3 * length_px_);
    for (int y = 0; y < input_.size_px.y; ++y) {
      for (int x = 0; x < input_.size_px.x; ++x)
        flows_.at({x, y}) = is_form({x, y})
                                ? flow_at(mean(turning.at({x, y})), input_.at({x, y}).seen_normal)
                                : usual();
    }
  }

  glm::dvec2 usual() const { return {std::cos(angle_), -std::sin(angle_)}; }

  /// In a basis of the surface's plane: one axis down its slope, which the camera sees shortened.
  glm::dvec2 flow_at(glm::dvec3 turning, glm::dvec3 normal) const {
    const double facing = std::clamp(normal.z, 0.15, 1.0);
    const glm::dvec2 tilted(normal.x, normal.y);
    const double tilt = glm::length(tilted);
    const glm::dvec2 slope = tilt > 1e-9 ? tilted / tilt : glm::dvec2(1.0, 0.0);
    const glm::dvec2 level(-slope.y, slope.x);
    const auto product = [&](glm::dvec2 a, glm::dvec2 b) {
      return a.x * b.x * turning.x + (a.x * b.y + a.y * b.x) * turning.y + a.y * b.y * turning.z;
    };
    double ss = facing * facing * product(slope, slope);
    double sl = facing * product(slope, level);
    double ll = product(level, level);
    const double all = ss + ll;
    const double apart = std::hypot(ss - ll, 2.0 * sl) / std::max(all, 1e-12);
    const double lost =
        all * std::max(0.5 - apart, 0.0) + std::max(std::pow(0.25 / length_px_, 2.0) - all, 0.0);
    const glm::dvec2 fallback =
        glm::normalize(glm::dvec2(glm::dot(usual(), slope) / facing, glm::dot(usual(), level)));
    ss += lost * fallback.x * fallback.x;
    sl += lost * fallback.x * fallback.y;
    ll += lost * fallback.y * fallback.y;
    const double most = 0.5 * std::atan2(2.0 * sl, ss - ll);
    return glm::normalize(facing * std::cos(most) * slope + std::sin(most) * level);
  }

  const BranchImage& input_;
  const Json& parameters_;
  double width_px_;
  double length_px_;
  double angle_;
  int samples_ = 1;
  double step_px_ = 1.0;
  bool follows_ = false;
  double deviation_ = 1.0;
  Image<glm::dvec2> flows_;
};

}  // namespace

BranchImage hatching(const BranchImage& input, const Json& parameters, double resolution_scale) {
  return Hatching(input, parameters, resolution_scale).drawn();
}

}  // namespace cutaway::reference
