#include "session/quality_control.h"

#include <algorithm>
#include <cmath>

namespace cutaway {

namespace {

// Cost goes with the number of pixels.
const std::vector<StepControl::Step> kResolutionSteps = {
    {1.0, 1.0}, {0.75, 0.5625}, {0.5, 0.25}, {0.35, 0.1225}, {0.25, 0.0625}};

// JPEG quality and the bytes it makes, of those at 80: typical of our pictures, the control
// corrects the rest.
const std::vector<StepControl::Step> kCompressionSteps = {
    {80.0, 1.0}, {65.0, 0.72}, {50.0, 0.58}, {35.0, 0.46}, {25.0, 0.37}};

/// Of what was known of rays' cost before, beside the newest frame.
constexpr double kKept = 0.7;

double pixels_of(Viewport viewport) { return double(viewport.width_px) * viewport.height_px; }

}  // namespace

FrameQuality still_quality(const SessionSettings& settings, Viewport viewport) {
  FrameQuality quality;
  const std::int64_t pixels = std::int64_t{viewport.width_px} * viewport.height_px;
  quality.supersampling = settings.still_supersampling;
  while (quality.supersampling > 1 &&
         pixels * quality.supersampling * quality.supersampling > settings.still_rays)
    --quality.supersampling;
  quality.jpeg_quality = settings.still_jpeg_quality;
  quality.chroma = ChromaSampling::yuv444;
  quality.light = LightDetail::full;
  quality.still = true;
  return quality;
}

QualityControl::QualityControl(const SessionSettings& settings)
    : settings_(settings),
      resolution_(kResolutionSteps, settings.frame_budget, settings.first_resolution_scale),
      compression_(kCompressionSteps, settings.frame_budget, kCompressionSteps.front().value) {}

void QualityControl::rendered(const FrameQuality& quality, Milliseconds cost) {
  if (!made_with_present_steps(quality)) return;
  resolution_.observe(compression_.at_last() ? std::max(cost, transfer_) : cost);
}

void QualityControl::acknowledged(const FrameQuality& quality, std::size_t bytes,
                                  std::size_t bytes_in_flight, Milliseconds round_trip) {
  link_.acknowledged(bytes_in_flight, round_trip);
  if (!made_with_present_steps(quality)) return;
  transfer_ = link_.transfer_time(bytes);
  compression_.observe(transfer_);
}

void QualityControl::cast_rays(const FrameQuality& quality, Viewport viewport,
                               Milliseconds rendering) {
  const double rays_a_pixel = quality.resolution_scale * quality.supersampling;
  const double kept = rays_known_.frames > 1 ? kKept : 0.0;
  rays_known_ = {
      .frames = rays_known_.frames + 1,
      .time = kept * rays_known_.time + rendering,
      .rays = kept * rays_known_.rays + pixels_of(viewport) * rays_a_pixel * rays_a_pixel};
}

// A slice is a few points a pixel, which cost next to nothing.
FrameQuality QualityControl::still(Viewport viewport) const {
  FrameQuality quality = still_quality(settings_, viewport);
  if (viewport.kind != ViewKind::volume) return quality;
  if (!knows_rays()) quality.supersampling = 1;
  const Milliseconds with_one_ray =
      rays_known_.time * (pixels_of(viewport) / std::max(rays_known_.rays, 1.0));
  while (quality.supersampling > 1 &&
         with_one_ray * quality.supersampling * quality.supersampling > settings_.still_budget)
    --quality.supersampling;
  return quality;
}

FrameQuality QualityControl::interactive() const {
  FrameQuality quality;
  quality.resolution_scale = resolution_.value();
  quality.jpeg_quality = static_cast<int>(std::lround(compression_.value()));
  return quality;
}

Milliseconds QualityControl::interval() const {
  return transfer_ > settings_.frame_budget ? transfer_ : Milliseconds(0.0);
}

// A still frame, or one that was under way when a step changed, says nothing about the present
// steps.
bool QualityControl::made_with_present_steps(const FrameQuality& quality) const {
  return quality == interactive();
}

}  // namespace cutaway
