// Which quality the next frame has, from what the last ones cost.
#pragma once

#include "session/ends.h"
#include "session/link_estimate.h"
#include "session/settings.h"
#include "session/step_control.h"

namespace cutaway {

/// Of the refined picture of a scene at rest: with as many rays a pixel as the settings allow for a
/// viewport of that size.
FrameQuality still_quality(const SessionSettings& settings, Viewport viewport);

/// Render time governs resolution. The link governs JPEG quality, then the frame rate, and
/// resolution once quality is at its lowest. The still quality is fixed, but for the rays a pixel,
/// which have to fit the still's budget by what the frames before it cost.
class QualityControl {
 public:
  explicit QualityControl(const SessionSettings& settings);

  void rendered(const FrameQuality& quality, Milliseconds cost);
  /// Of a frame for which rays were cast: what a still of this viewport will take follows from it.
  void cast_rays(const FrameQuality& quality, Viewport viewport, Milliseconds rendering);
  void acknowledged(const FrameQuality& quality, std::size_t bytes, std::size_t bytes_in_flight,
                    Milliseconds round_trip);

  FrameQuality interactive() const;
  FrameQuality still(Viewport viewport) const;
  /// The least time between two interactive frames that keeps them from queueing on the link.
  Milliseconds interval() const;

 private:
  bool made_with_present_steps(const FrameQuality& quality) const;

  SessionSettings settings_;
  int frames_cast_ = 0;
  Milliseconds ray_{0.0};  ///< smoothed
  StepControl resolution_;
  StepControl compression_;
  LinkEstimate link_;
  Milliseconds transfer_{0.0};  ///< of the newest interactive frame
};

}  // namespace cutaway
