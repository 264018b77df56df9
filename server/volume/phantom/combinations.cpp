#include <algorithm>
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

  /// However many parts meet, smooth minima never sink more than `blend` below the smallest.
  Bounds bounds(const Ball& ball) const override {
    constexpr float kFar = std::numeric_limits<float>::max();
    Bounds all{kFar, kFar};
    for (const ShapePtr& part : parts_) {
      const Bounds one = part->bounds(ball);
      all = {std::min(all.low_mm, one.low_mm), std::min(all.high_mm, one.high_mm)};
    }
    return {parts_.size() > 1 ? all.low_mm - blend_ : all.low_mm, all.high_mm};
  }

  /// A part matters only where it comes within `blend` of the running minimum, which may itself lie
  /// `blend` below the parts seen so far.
  ShapePtr pruned(const Ball& ball) const override {
    const float nearest = bounds(ball).high_mm;
    std::vector<ShapePtr> kept;
    for (const ShapePtr& part : parts_) {
      if (part->bounds(ball).low_mm <= nearest + 2.0f * blend_) kept.push_back(prune(part, ball));
    }
    if (kept.size() == 1) return kept[0];
    return std::make_shared<Union>(blend_, std::move(kept));
  }

 private:
  float blend_;
  std::vector<ShapePtr> parts_;
};

class Complement final : public Shape {
 public:
  explicit Complement(ShapePtr shape) : shape_(std::move(shape)) {}
  float distance_mm(glm::vec3 p) const override { return -shape_->distance_mm(p); }
  Bounds bounds(const Ball& ball) const override {
    const Bounds bounds = shape_->bounds(ball);
    return {-bounds.high_mm, -bounds.low_mm};
  }
  ShapePtr pruned(const Ball& ball) const override {
    return std::make_shared<Complement>(prune(shape_, ball));
  }

 private:
  ShapePtr shape_;
};

/// By De Morgan; its own class because two extra calls per part and voxel would show.
class Intersection final : public Shape {
 public:
  Intersection(float blend, std::vector<ShapePtr> parts) : blend_(blend), parts_(std::move(parts)) {
    check(!parts_.empty(), "an intersection needs a part");
  }

  float distance_mm(glm::vec3 p) const override {
    float distance = parts_[0]->distance_mm(p);
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      distance = -smooth_min(-distance, -parts_[i]->distance_mm(p), blend_);
    }
    return distance;
  }

  Bounds bounds(const Ball& ball) const override {
    constexpr float kFar = std::numeric_limits<float>::lowest();
    Bounds all{kFar, kFar};
    for (const ShapePtr& part : parts_) {
      const Bounds one = part->bounds(ball);
      all = {std::max(all.low_mm, one.low_mm), std::max(all.high_mm, one.high_mm)};
    }
    return {all.low_mm, parts_.size() > 1 ? all.high_mm + blend_ : all.high_mm};
  }

  ShapePtr pruned(const Ball& ball) const override {
    const float farthest = bounds(ball).low_mm;
    std::vector<ShapePtr> kept;
    for (const ShapePtr& part : parts_) {
      if (part->bounds(ball).high_mm >= farthest - 2.0f * blend_) kept.push_back(prune(part, ball));
    }
    if (kept.size() == 1) return kept[0];
    return std::make_shared<Intersection>(blend_, std::move(kept));
  }

 private:
  float blend_;
  std::vector<ShapePtr> parts_;
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

class Grooved final : public Shape {
 public:
  Grooved(const Grooves& grooves, ShapePtr shape) : grooves_(grooves), shape_(std::move(shape)) {}

  float distance_mm(glm::vec3 p) const override {
    constexpr float kWarp = 0.55f;
    const glm::vec3 q = p * (1.0f / grooves_.spacing_mm);
    const glm::vec3 warped = q + kWarp * gradient_noise3(q * 0.8f, grooves_.seed);
    const float noise = std::abs(gradient_noise(warped, grooves_.seed + 7u));
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

}  // namespace cutaway::phantom
