#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "volume/phantom/noise.h"
#include "volume/phantom/shape.h"

namespace cutaway::phantom {

namespace {

/// Quadratic smooth minimum: at most blend/4 below the smaller of the two, and equal to it where
/// they differ by `blend` or more.
float smooth_min(float a, float b, float blend) {
  const float overlap = std::max(blend - std::abs(a - b), 0.0f);
  return std::min(a, b) - (blend > 0.0f ? overlap * overlap / (4.0f * blend) : 0.0f);
}

/// As a smooth minimum rises with each of its arguments, limits of the parts give limits of the
/// whole.
Bounds smooth_min(const Bounds& a, const Bounds& b, float blend) {
  return {smooth_min(a.low_mm, b.low_mm, blend), smooth_min(a.high_mm, b.high_mm, blend)};
}

Bounds negative(const Bounds& bounds) { return {-bounds.high_mm, -bounds.low_mm}; }

/// The parts of a smooth minimum that matter within `ball`. A part that stays `blend` above the
/// minimum of those before it changes nothing; one that stays `blend` below makes those before it
/// matter no more. `sign` -1 selects for a maximum.
std::vector<ShapePtr> parts_that_matter(const std::vector<ShapePtr>& parts, const Ball& ball,
                                        float blend, float sign) {
  std::vector<ShapePtr> kept;
  Bounds running{std::numeric_limits<float>::lowest(), 0.0f};
  for (const ShapePtr& part : parts) {
    const Bounds bounds = sign > 0.0f ? part->bounds(ball) : negative(part->bounds(ball));
    if (!kept.empty() && bounds.low_mm >= running.high_mm + blend) continue;
    if (running.low_mm >= bounds.high_mm + blend) kept.clear();
    running = kept.empty() ? bounds : smooth_min(running, bounds, blend);
    kept.push_back(part);
  }
  for (ShapePtr& part : kept) part = prune(part, ball);
  return kept;
}

class Union final : public Shape {
 public:
  Union(float blend, std::vector<ShapePtr> parts) : blend_(blend), parts_(std::move(parts)) {
    check(!parts_.empty(), "a union needs a part");
  }

  float distance_mm(glm::vec3 p) const override {
    float distance = parts_[0]->distance_mm(p);
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      distance = smooth_min(distance, parts_[i]->distance_mm(p), blend_);
    }
    return distance;
  }

  Bounds bounds(const Ball& ball) const override {
    Bounds all = parts_[0]->bounds(ball);
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      all = smooth_min(all, parts_[i]->bounds(ball), blend_);
    }
    return all;
  }

  ShapePtr pruned(const Ball& ball) const override {
    std::vector<ShapePtr> kept = parts_that_matter(parts_, ball, blend_, 1.0f);
    return kept.size() == 1 ? kept[0] : std::make_shared<Union>(blend_, std::move(kept));
  }

 private:
  float blend_;
  std::vector<ShapePtr> parts_;
};

/// By De Morgan the complement of a union of complements; its own class to save two calls per part
/// and voxel.
class Intersection final : public Shape {
 public:
  Intersection(float blend, std::vector<ShapePtr> parts) : blend_(blend), parts_(std::move(parts)) {
    check(!parts_.empty(), "an intersection needs a part");
  }

  float distance_mm(glm::vec3 p) const override {
    float negated = -parts_[0]->distance_mm(p);
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      negated = smooth_min(negated, -parts_[i]->distance_mm(p), blend_);
    }
    return -negated;
  }

  Bounds bounds(const Ball& ball) const override {
    Bounds all = negative(parts_[0]->bounds(ball));
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      all = smooth_min(all, negative(parts_[i]->bounds(ball)), blend_);
    }
    return negative(all);
  }

  ShapePtr pruned(const Ball& ball) const override {
    std::vector<ShapePtr> kept = parts_that_matter(parts_, ball, blend_, -1.0f);
    return kept.size() == 1 ? kept[0] : std::make_shared<Intersection>(blend_, std::move(kept));
  }

 private:
  float blend_;
  std::vector<ShapePtr> parts_;
};

class Complement final : public Shape {
 public:
  explicit Complement(ShapePtr shape) : shape_(std::move(shape)) {}
  float distance_mm(glm::vec3 p) const override { return -shape_->distance_mm(p); }
  Bounds bounds(const Ball& ball) const override { return negative(shape_->bounds(ball)); }
  ShapePtr pruned(const Ball& ball) const override {
    return std::make_shared<Complement>(prune(shape_, ball));
  }

 private:
  ShapePtr shape_;
};

class Grown final : public Shape {
 public:
  Grown(float offset, ShapePtr shape) : offset_(offset), shape_(std::move(shape)) {}
  float distance_mm(glm::vec3 p) const override { return shape_->distance_mm(p) - offset_; }
  Bounds bounds(const Ball& ball) const override {
    const Bounds bounds = shape_->bounds(ball);
    return {bounds.low_mm - offset_, bounds.high_mm - offset_};
  }
  ShapePtr pruned(const Ball& ball) const override {
    return std::make_shared<Grown>(offset_, prune(shape_, ball));
  }

 private:
  float offset_;
  ShapePtr shape_;
};

enum class Side { both, right };

/// Folding or reflecting space moves no two points apart, so a ball's image fits the ball about the
/// image.
class Mirrored final : public Shape {
 public:
  Mirrored(Side side, ShapePtr shape) : side_(side), shape_(std::move(shape)) {}
  float distance_mm(glm::vec3 p) const override { return shape_->distance_mm(image(p)); }
  Bounds bounds(const Ball& ball) const override { return shape_->bounds(image(ball)); }
  ShapePtr pruned(const Ball& ball) const override {
    return std::make_shared<Mirrored>(side_, prune(shape_, image(ball)));
  }

 private:
  glm::vec3 image(glm::vec3 p) const {
    return {side_ == Side::both ? std::abs(p.x) : -p.x, p.y, p.z};
  }
  Ball image(const Ball& ball) const { return {image(ball.centre_mm), ball.radius_mm}; }

  Side side_;
  ShapePtr shape_;
};

class Moved final : public Shape {
 public:
  Moved(glm::vec3 offset, ShapePtr shape) : offset_(offset), shape_(std::move(shape)) {}
  float distance_mm(glm::vec3 p) const override { return shape_->distance_mm(p - offset_); }
  Bounds bounds(const Ball& ball) const override { return shape_->bounds(image(ball)); }
  ShapePtr pruned(const Ball& ball) const override {
    return std::make_shared<Moved>(offset_, prune(shape_, image(ball)));
  }

 private:
  Ball image(const Ball& ball) const { return {ball.centre_mm - offset_, ball.radius_mm}; }

  glm::vec3 offset_;
  ShapePtr shape_;
};

class Rough final : public Shape {
 public:
  Rough(const Roughness& roughness, ShapePtr shape)
      : roughness_(roughness), shape_(std::move(shape)) {}
  float distance_mm(glm::vec3 p) const override {
    const float noise = gradient_noise(p * (1.0f / roughness_.scale_mm), roughness_.seed);
    return shape_->distance_mm(p) + roughness_.amplitude_mm * noise;
  }
  Bounds bounds(const Ball& ball) const override {
    constexpr float kLargestNoise = 1.1f;
    const Bounds bounds = shape_->bounds(ball);
    const float reach = roughness_.amplitude_mm * kLargestNoise;
    return {bounds.low_mm - reach, bounds.high_mm + reach};
  }
  ShapePtr pruned(const Ball& ball) const override {
    return std::make_shared<Rough>(roughness_, prune(shape_, ball));
  }

 private:
  Roughness roughness_;
  ShapePtr shape_;
};

/// Zero on winding surfaces about `spacing_mm` apart, at most about 1 between them.
float winding_noise(glm::vec3 p, float spacing_mm, std::uint32_t seed) {
  constexpr float kWarp = 0.55f;
  const glm::vec3 q = p * (1.0f / spacing_mm);
  const glm::vec3 warped = q + kWarp * gradient_noise3(q * 0.8f, seed);
  return std::abs(gradient_noise(warped, seed + 7u));
}

class Grooved final : public Shape {
 public:
  Grooved(const Grooves& grooves, ShapePtr shape) : grooves_(grooves), shape_(std::move(shape)) {}

  float distance_mm(glm::vec3 p) const override {
    const float noise = winding_noise(p, grooves_.spacing_mm, grooves_.seed);
    const float t = std::max(1.0f - noise / grooves_.width, 0.0f);
    return shape_->distance_mm(p) + grooves_.depth_mm * t * t * (3.0f - 2.0f * t);
  }

  Bounds bounds(const Ball& ball) const override {
    const Bounds bounds = shape_->bounds(ball);
    return {bounds.low_mm, bounds.high_mm + grooves_.depth_mm};
  }
  ShapePtr pruned(const Ball& ball) const override {
    return std::make_shared<Grooved>(grooves_, prune(shape_, ball));
  }

 private:
  Grooves grooves_;
  ShapePtr shape_;
};

class Sheets final : public Shape {
 public:
  Sheets(float thickness_mm, float spacing_mm, std::uint32_t seed)
      : half_mm_(0.5f * thickness_mm), spacing_mm_(spacing_mm), seed_(seed) {}

  float distance_mm(glm::vec3 p) const override {
    constexpr float kUnitsPerNoise =
        0.7f;  // the noise rises from 0 by about 1 within 0.7 of its spacing
    return kUnitsPerNoise * spacing_mm_ * winding_noise(p, spacing_mm_, seed_) - half_mm_;
  }
  Bounds bounds(const Ball&) const override { return {-half_mm_, spacing_mm_}; }

 private:
  float half_mm_;
  float spacing_mm_;
  std::uint32_t seed_;
};

}  // namespace

ShapePtr join(float blend_mm, std::vector<ShapePtr> parts) {
  return std::make_shared<Union>(blend_mm, std::move(parts));
}

ShapePtr meet(float blend_mm, std::vector<ShapePtr> parts) {
  return std::make_shared<Intersection>(blend_mm, std::move(parts));
}

ShapePtr carve(float blend_mm, const ShapePtr& solid, const ShapePtr& tool) {
  return meet(blend_mm, {solid, complement(tool)});
}

ShapePtr complement(const ShapePtr& shape) { return std::make_shared<Complement>(shape); }

ShapePtr grow(float offset_mm, const ShapePtr& shape) {
  return std::make_shared<Grown>(offset_mm, shape);
}

ShapePtr both_sides(const ShapePtr& shape) { return std::make_shared<Mirrored>(Side::both, shape); }

ShapePtr reflected(const ShapePtr& shape) { return std::make_shared<Mirrored>(Side::right, shape); }

ShapePtr moved(glm::vec3 offset_mm, const ShapePtr& shape) {
  return std::make_shared<Moved>(offset_mm, shape);
}

ShapePtr roughen(const Roughness& roughness, const ShapePtr& shape) {
  return std::make_shared<Rough>(roughness, shape);
}

ShapePtr groove(const Grooves& grooves, const ShapePtr& shape) {
  return std::make_shared<Grooved>(grooves, shape);
}

ShapePtr sheets(float thickness_mm, float spacing_mm, std::uint32_t seed) {
  return std::make_shared<Sheets>(thickness_mm, spacing_mm, seed);
}

}  // namespace cutaway::phantom
