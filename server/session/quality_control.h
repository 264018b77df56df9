// Which quality the next frame has, from what the last ones cost.
#pragma once

#include "session/frame_source.h"
#include "session/link_estimate.h"
#include "session/settings.h"
#include "session/step_control.h"

namespace cutaway {

/// Of the refined picture of a scene at rest: with as many rays a pixel as the settings allow for a
/// viewport of that size.
FrameQuality still_quality(const SessionSettings& settings, Viewport viewport);

/// Render time governs resolution. The link governs JPEG quality, then the frame rate, and
/// resolution once quality is at its lowest. The still quality is fixed, but for the rays a pixel,
/// which have to fit the still's budget by what the frames before it cost. That is the time from
/// their begin to their last pixel, the turns of other sessions in between included: the budget is
/// what a client waits, and where many wait, fewer rays are what helps all of them.
class QualityControl {
 public:
  explicit QualityControl(const SessionSettings& settings);

  void rendered(const FrameQuality& quality, Milliseconds cost);
  /// Of a frame for which rays were cast: what a still of this viewport will take follows from it.
  /// The first one makes buffers and programs, too, and so says how much it may be at the most;
  /// what comes after it takes its place.
  void cast_rays(const FrameQuality& quality, Viewport viewport, Milliseconds rendering);
  void acknowledged(const FrameQuality& quality, std::size_t bytes, std::size_t bytes_in_flight,
                    Milliseconds round_trip);

  /// What rays have cost so far says nothing of those to come: they are another volume's.
  void forget_rays() { rays_known_ = {}; }
  /// Whether anything is known of what a ray costs.
  bool knows_rays() const { return rays_known_.frames > 0; }

  FrameQuality interactive() const;
  /// One ray a pixel where nothing is known of its cost.
  FrameQuality still(Viewport viewport) const;
  /// The least time between two interactive frames that keeps them from queueing on the link.
  Milliseconds interval() const;

 private:
  /// Of the frames so far, the newest with the most weight: frames of a few rays and of many.
  struct RaysKnown {
    int frames = 0;
    Milliseconds time{0.0};
    double rays = 0.0;
  };

  bool made_with_present_steps(const FrameQuality& quality) const;

  SessionSettings settings_;
  RaysKnown rays_known_;
  StepControl resolution_;
  StepControl compression_;
  LinkEstimate link_;
  Milliseconds transfer_{0.0};  ///< of the newest interactive frame
};

}  // namespace cutaway
