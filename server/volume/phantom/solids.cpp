#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "volume/phantom/shape.h"

namespace cutaway::phantom {

namespace {

Bounds around(float distance_mm, float radius_mm) {
  return {distance_mm - radius_mm, distance_mm + radius_mm};
}

/// Rows of the rotation from patient space to a frame with the given z axis.
glm::mat3 frame_of(glm::vec3 up) {
  const glm::vec3 z = glm::normalize(up);
  const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), z));
  return glm::transpose(glm::mat3(x, glm::cross(z, x), z));
}

class Sphere final : public Shape {
 public:
  Sphere(glm::vec3 centre, float radius) : centre_(centre), radius_(radius) {}
  float distance_mm(glm::vec3 p) const override { return glm::length(p - centre_) - radius_; }
  Bounds bounds(const Ball& ball) const override {
    return around(distance_mm(ball.centre_mm), ball.radius_mm);
  }

 private:
  glm::vec3 centre_;
  float radius_;
};

/// With k0 = |p/r| and k1 = |p/r^2| the distance is about (k0 - 1) k0/k1, and k0/k1 lies between
/// the smallest and the largest radius; k0 changes by at most 1/(smallest radius) per mm. The
/// bounds follow.
class Ellipsoid final : public Shape {
 public:
  Ellipsoid(glm::vec3 centre, glm::vec3 radii, const glm::mat3& frame)
      : centre_(centre),
        inverse_(1.0f / radii),
        frame_(frame),
        smallest_(std::min({radii.x, radii.y, radii.z})),
        largest_(std::max({radii.x, radii.y, radii.z})) {}

  float distance_mm(glm::vec3 p) const override {
    const glm::vec3 scaled = (frame_ * (p - centre_)) * inverse_;
    const float k0 = glm::length(scaled);
    const float k1 = glm::length(scaled * inverse_);
    return k1 > 0.0f ? (k0 - 1.0f) * (k0 / k1) : -smallest_;
  }

  Bounds bounds(const Ball& ball) const override {
    const float k0 = glm::length((frame_ * (ball.centre_mm - centre_)) * inverse_);
    const float low = k0 - ball.radius_mm / smallest_ - 1.0f;
    const float high = k0 + ball.radius_mm / smallest_ - 1.0f;
    return {low * (low > 0.0f ? smallest_ : largest_), high * (high > 0.0f ? largest_ : smallest_)};
  }

 private:
  glm::vec3 centre_;
  glm::vec3 inverse_;
  glm::mat3 frame_;
  float smallest_;
  float largest_;
};

class RoundedBox final : public Shape {
 public:
  RoundedBox(glm::vec3 centre, glm::vec3 half, float rounding, const glm::mat3& frame)
      : centre_(centre), core_(half - rounding), rounding_(rounding), frame_(frame) {}

  float distance_mm(glm::vec3 p) const override {
    const glm::vec3 q = glm::abs(frame_ * (p - centre_)) - core_;
    const float inside = std::min(std::max({q.x, q.y, q.z}), 0.0f);
    return glm::length(glm::max(q, 0.0f)) + inside - rounding_;
  }
  Bounds bounds(const Ball& ball) const override {
    return around(distance_mm(ball.centre_mm), ball.radius_mm);
  }

 private:
  glm::vec3 centre_;
  glm::vec3 core_;
  float rounding_;
  glm::mat3 frame_;
};

class HalfSpace final : public Shape {
 public:
  HalfSpace(glm::vec3 point, glm::vec3 normal) : point_(point), normal_(glm::normalize(normal)) {}
  float distance_mm(glm::vec3 p) const override { return glm::dot(p - point_, normal_); }
  Bounds bounds(const Ball& ball) const override {
    return around(distance_mm(ball.centre_mm), ball.radius_mm);
  }

 private:
  glm::vec3 point_;
  glm::vec3 normal_;
};

/// The hull of two balls: all balls between them, with radii that change linearly. The ball nearest
/// to a point lies beside the foot of the perpendicular, by its length times the tangent of the
/// taper.
class Segment {
 public:
  Segment(const Knot& from, const Knot& to, glm::vec3 weight)
      : from_{from.position_mm * weight, from.radius_mm},
        along_((to.position_mm - from.position_mm) * weight),
        growth_(to.radius_mm - from.radius_mm),
        inverse_length_(1.0f / std::max(glm::length(along_), 1e-3f)) {
    const float room = glm::dot(along_, along_) - growth_ * growth_;
    // Where one ball holds the other, any point is nearest to the larger one.
    tangent_ = room > 0.0f ? growth_ / std::sqrt(room) : (growth_ > 0.0f ? kSteep : -kSteep);
  }

  float distance_mm(glm::vec3 weighted) const {
    const glm::vec3 q = weighted - from_.position_mm;
    const float foot = glm::dot(q, along_) * inverse_length_;
    const float across = std::sqrt(std::max(glm::dot(q, q) - foot * foot, 0.0f));
    const float t = glm::clamp((foot + across * tangent_) * inverse_length_, 0.0f, 1.0f);
    return glm::length(q - t * along_) - (from_.radius_mm + t * growth_);
  }

 private:
  static constexpr float kSteep = 1e6f;

  Knot from_;
  glm::vec3 along_;
  float growth_;
  float inverse_length_;
  float tangent_;
};

/// Computed in a space that is shrunk by `weight`, so distances are never too large.
class Tube final : public Shape {
 public:
  Tube(std::vector<Segment> segments, glm::vec3 weight)
      : segments_(std::move(segments)), weight_(weight) {}

  float distance_mm(glm::vec3 p) const override {
    const glm::vec3 weighted = p * weight_;
    float nearest = std::numeric_limits<float>::max();
    for (const Segment& segment : segments_) {
      nearest = std::min(nearest, segment.distance_mm(weighted));
    }
    return nearest;
  }

  Bounds bounds(const Ball& ball) const override {
    return around(distance_mm(ball.centre_mm), ball.radius_mm);
  }

  ShapePtr pruned(const Ball& ball) const override {
    const glm::vec3 weighted = ball.centre_mm * weight_;
    const float nearest = distance_mm(ball.centre_mm);
    std::vector<Segment> kept;
    std::copy_if(segments_.begin(), segments_.end(), std::back_inserter(kept),
                 [&](const Segment& segment) {
                   return segment.distance_mm(weighted) <= nearest + 2.0f * ball.radius_mm;
                 });
    return kept.size() == segments_.size() ? nullptr
                                           : std::make_shared<Tube>(std::move(kept), weight_);
  }

 private:
  std::vector<Segment> segments_;
  glm::vec3 weight_;
};

ShapePtr tube_along(const std::vector<Knot>& knots, glm::vec3 weight) {
  check(knots.size() >= 2, "a tube needs two knots");
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < knots.size(); ++i)
    segments.emplace_back(knots[i - 1], knots[i], weight);
  return std::make_shared<Tube>(std::move(segments), weight);
}

/// Uniform Catmull-Rom: passes through b and c with the slopes (c - a)/2 and (d - b)/2.
template <typename T>
T catmull_rom(T a, T b, T c, T d, float t) {
  const T linear = (c - a) * 0.5f;
  const T square = a - b * 2.5f + c * 2.0f - d * 0.5f;
  const T cube = (d - a) * 0.5f + (b - c) * 1.5f;
  return b + t * (linear + t * (square + t * cube));
}

}  // namespace

ShapePtr prune(const ShapePtr& shape, const Ball& ball) {
  ShapePtr smaller = shape->pruned(ball);
  return smaller ? smaller : shape;
}

ShapePtr sphere(glm::vec3 centre_mm, float radius_mm) {
  return std::make_shared<Sphere>(centre_mm, radius_mm);
}

ShapePtr ellipsoid(glm::vec3 centre_mm, glm::vec3 radii_mm) {
  return std::make_shared<Ellipsoid>(centre_mm, radii_mm, glm::mat3(1.0f));
}

ShapePtr ellipsoid(glm::vec3 centre_mm, glm::vec3 radii_mm, glm::vec3 up) {
  return std::make_shared<Ellipsoid>(centre_mm, radii_mm, frame_of(up));
}

ShapePtr rounded_box(glm::vec3 centre_mm, glm::vec3 half_mm, float rounding_mm, glm::vec3 up) {
  return std::make_shared<RoundedBox>(centre_mm, half_mm, rounding_mm, frame_of(up));
}

ShapePtr half_space(glm::vec3 point_mm, glm::vec3 normal) {
  return std::make_shared<HalfSpace>(point_mm, normal);
}

ShapePtr rod(const std::vector<Knot>& knots) { return tube_along(knots, glm::vec3(1.0f)); }

ShapePtr tube(const std::vector<Knot>& knots, glm::vec3 weight) {
  constexpr int kPieces = 6;
  std::vector<Knot> fine;
  const auto knot = [&](std::ptrdiff_t i) {
    return knots[std::clamp<std::ptrdiff_t>(i, 0, std::ptrdiff_t(knots.size()) - 1)];
  };
  for (std::ptrdiff_t i = 0; i + 1 < std::ptrdiff_t(knots.size()); ++i) {
    const Knot k[4] = {knot(i - 1), knot(i), knot(i + 1), knot(i + 2)};
    for (int piece = 0; piece < kPieces; ++piece) {
      const float t = float(piece) / kPieces;
      fine.push_back(
          {catmull_rom(k[0].position_mm, k[1].position_mm, k[2].position_mm, k[3].position_mm, t),
           catmull_rom(k[0].radius_mm, k[1].radius_mm, k[2].radius_mm, k[3].radius_mm, t)});
    }
  }
  fine.push_back(knots.back());
  return tube_along(fine, weight);
}

}  // namespace cutaway::phantom
