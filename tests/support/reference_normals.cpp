#include "support/reference_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cutaway::reference {

namespace {

glm::dvec3 index_of(const Volume& volume, glm::dvec3 position_mm) {
  return {patient_to_index(volume.geometry) * glm::dvec4(position_mm, 1.0)};
}

glm::dvec3 patient_gradient(const Volume& volume, glm::dvec3 per_voxel) {
  return volume.geometry.direction_patient * (per_voxel / volume.geometry.spacing_mm);
}

/// Of the voxels along an axis around a place: their offsets and the Gaussian's weight of each.
struct AxisWeights {
  int first = 0;
  std::vector<double> offsets;
  std::vector<double> weights;
};

AxisWeights gaussian_along(double at, double sigma, int size) {
  AxisWeights axis;
  axis.first = std::max(0, int(std::ceil(at - 3.5 * sigma)));
  double sum = 0.0;
  double mean = 0.0;
  for (int i = axis.first; i <= std::min(size - 1, int(std::floor(at + 3.5 * sigma))); ++i) {
    axis.offsets.push_back(i - at);
    axis.weights.push_back(std::exp(-0.5 * (i - at) * (i - at) / (sigma * sigma)));
    sum += axis.weights.back();
    mean += axis.weights.back() * axis.offsets.back();
  }
  for (double& weight : axis.weights) weight /= sum;
  for (double& offset : axis.offsets) offset -= mean / sum;
  return axis;
}

double variance(const AxisWeights& axis) {
  double sum = 0.0;
  for (std::size_t i = 0; i < axis.weights.size(); ++i)
    sum += axis.weights[i] * axis.offsets[i] * axis.offsets[i];
  return sum;
}

/// Of the plane through the voxels that fits best under the Gaussian: within the volume the
/// Gaussian's own gradient, and at its border that of what is there.
glm::dvec3 gaussian_gradient(const Volume& volume, glm::dvec3 index, glm::dvec3 sigma) {
  const glm::ivec3 size = volume.geometry.size_voxels;
  std::array<AxisWeights, 3> axes;
  for (int axis = 0; axis < 3; ++axis)
    axes[axis] = gaussian_along(index[axis], sigma[axis], size[axis]);
  glm::dvec3 moment(0.0);
  for (std::size_t k = 0; k < axes[2].weights.size(); ++k) {
    for (std::size_t j = 0; j < axes[1].weights.size(); ++j) {
      for (std::size_t i = 0; i < axes[0].weights.size(); ++i) {
        const glm::ivec3 at(axes[0].first + i, axes[1].first + j, axes[2].first + k);
        moment += axes[0].weights[i] * axes[1].weights[j] * axes[2].weights[k] *
                  value_at(volume, at) *
                  glm::dvec3(axes[0].offsets[i], axes[1].offsets[j], axes[2].offsets[k]);
      }
    }
  }
  glm::dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis)
    if (variance(axes[axis]) > 0.0) gradient[axis] = moment[axis] / variance(axes[axis]);
  return gradient;
}

/// A voxel's value; beyond the volume what continues the last two evenly.
double continued(const Volume& volume, glm::ivec3 at) {
  for (int axis = 0; axis < 3; ++axis) {
    const int last = volume.geometry.size_voxels[axis] - 1;
    if (at[axis] >= 0 && at[axis] <= last) continue;
    glm::ivec3 end = at;
    glm::ivec3 before = at;
    end[axis] = at[axis] < 0 ? 0 : last;
    before[axis] = std::clamp(at[axis] < 0 ? 1 : last - 1, 0, last);
    const int beyond = std::abs(at[axis] - end[axis]);
    return (1.0 + beyond) * continued(volume, end) - beyond * continued(volume, before);
  }
  return value_at(volume, at);
}

double b_spline(double x) {
  const double a = std::abs(x);
  if (a < 1.0) return (4.0 - 6.0 * a * a + 3.0 * a * a * a) / 6.0;
  return a < 2.0 ? std::pow(2.0 - a, 3.0) / 6.0 : 0.0;
}

double b_spline_slope(double x) {
  const double a = std::abs(x);
  const double slope = a < 1.0   ? -2.0 * a + 1.5 * a * a
                       : a < 2.0 ? -0.5 * (2.0 - a) * (2.0 - a)
                                 : 0.0;
  return x < 0.0 ? -slope : slope;
}

struct Spline {
  double value = 0.0;
  glm::dvec3 slope{0.0};  ///< per voxel
};

Spline spline_at(const Volume& volume, glm::dvec3 index) {
  const glm::dvec3 inside =
      glm::clamp(index, glm::dvec3(0.0), glm::dvec3(volume.geometry.size_voxels - 1));
  const glm::ivec3 below(glm::floor(inside));
  Spline spline;
  for (int i = 0; i < 64; ++i) {
    const glm::ivec3 at = below + glm::ivec3(i & 3, (i >> 2) & 3, i >> 4) - 1;
    const glm::dvec3 from = inside - glm::dvec3(at);
    const double value = continued(volume, at);
    const glm::dvec3 weight(b_spline(from.x), b_spline(from.y), b_spline(from.z));
    spline.value += value * weight.x * weight.y * weight.z;
    spline.slope += value * glm::dvec3(b_spline_slope(from.x) * weight.y * weight.z,
                                       weight.x * b_spline_slope(from.y) * weight.z,
                                       weight.x * weight.y * b_spline_slope(from.z));
  }
  return spline;
}

/// The crossing of the spline nearest to the hit, within half a voxel; where there is none the
/// place where it comes nearest to the limit.
double spline_hit_mm(const Volume& volume, const ViewRay& ray, double hit_mm,
                     const ValueBand& band) {
  const auto index = [&](double at_mm) {
    return index_of(volume, ray.origin_mm + at_mm * ray.direction);
  };
  const double met = sample(volume, index(hit_mm));
  const double limit =
      std::abs(met - band.lower) < std::abs(met - band.upper) ? band.lower : band.upper;
  const auto gap = [&](double at_mm) { return spline_at(volume, index(at_mm)).value - limit; };
  const double most_mm = 0.5 / glm::length(index(1.0) - index(0.0));
  constexpr int kSteps = 16;
  double best_mm = hit_mm;
  for (int i = 0; i < kSteps; ++i) {
    for (const double side : {-1.0, 1.0}) {
      double near_mm = hit_mm + side * most_mm * i / kSteps;
      double far_mm = hit_mm + side * most_mm * (i + 1) / kSteps;
      if (std::abs(gap(far_mm)) < std::abs(gap(best_mm))) best_mm = far_mm;
      if (gap(near_mm) * gap(far_mm) > 0.0) continue;
      for (int half = 0; half < 40; ++half) {
        const double middle_mm = 0.5 * (near_mm + far_mm);
        (gap(middle_mm) * gap(near_mm) > 0.0 ? near_mm : far_mm) = middle_mm;
      }
      return near_mm;
    }
  }
  return best_mm;
}

}  // namespace

double gaussian_mm(const Normals& normals, BranchName branch, const VolumeGeometry& geometry) {
  if (normals.scale == NormalScale::fixed) return normals.scale_mm;
  const glm::dvec3 spacing = geometry.spacing_mm;
  const double in_plane_mm = 2.5 * std::max(spacing.x, spacing.y);
  const double slices_mm = 1.5 * std::max({spacing.x, spacing.y, spacing.z});
  const double context_mm = std::max(in_plane_mm, slices_mm);
  return std::min(branch == BranchName::focus ? 0.5 * context_mm : context_mm,
                  12.0 * std::min({spacing.x, spacing.y, spacing.z}));
}

bool asks_for_other_normals(const Normals& normals) {
  return normals.scale == NormalScale::automatic || normals.scale_mm > 0.0 ||
         normals.reconstruction == Reconstruction::cubic;
}

SurfaceHit calmed(const SurfaceHit& hit, const Branch& branch, BranchName name,
                  const Volume& volume, const ViewRay& ray) {
  if (hit.is_cut || !asks_for_other_normals(branch.normals)) return hit;
  SurfaceHit calm = hit;
  if (branch.normals.reconstruction == Reconstruction::cubic)
    calm.distance_mm = spline_hit_mm(volume, ray, hit.distance_mm, branch.surface.band);
  const glm::dvec3 index = index_of(volume, ray.origin_mm + calm.distance_mm * ray.direction);
  const double sigma_mm = gaussian_mm(branch.normals, name, volume.geometry);
  const glm::dvec3 slope =
      sigma_mm > 0.0
          ? gaussian_gradient(volume, index, glm::max(sigma_mm / volume.geometry.spacing_mm, 0.8))
          : spline_at(volume, index).slope;
  if (glm::length(slope) == 0.0) return calm;
  const glm::dvec3 normal = -glm::normalize(patient_gradient(volume, slope));
  calm.normal = glm::dot(normal, hit.normal) < 0.0 ? -normal : normal;
  return calm;
}

}  // namespace cutaway::reference
