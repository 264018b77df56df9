#include "session/volume_opening.h"

#include <utility>

#include "core/latest_slot.h"

namespace cutaway {

namespace {

constexpr double kReportedStep = 0.05;

}  // namespace

VolumeOpening::VolumeOpening(std::shared_ptr<Strand> strand, VolumeLibrary& library,
                             Reports reports)
    : strand_(std::move(strand)),
      library_(library),
      reports_(std::move(reports)),
      callbacks_(strand_) {}

void VolumeOpening::begin(const std::string& id) {
  withdraw();
  volume_ = id;
  ticket_ = library_.open(id, relay(), callbacks_.bind<OpenOutcome>([this](OpenOutcome outcome) {
    finish(std::move(outcome));
  }));
}

void VolumeOpening::withdraw() {
  callbacks_.revoke();
  ticket_.reset();
  volume_.reset();
  reported_.reset();
}

// The loading thread may report thousands of times; only the newest waits for the strand.
ProgressSink VolumeOpening::relay() {
  auto newest = std::make_shared<LatestSlot<Step>>();
  auto hear = callbacks_.bind<std::shared_ptr<LatestSlot<Step>>>(
      [this](const std::shared_ptr<LatestSlot<Step>>& slot) {
        if (const std::optional<Step> step = slot->take()) progressed(*step);
      });
  return [newest, hear](LoadStage stage, double fraction) {
    if (!newest->put({stage, fraction})) hear(newest);
  };
}

void VolumeOpening::progressed(Step step) {
  const bool same_stage = reported_ && reported_->stage == step.stage;
  const bool far_enough = !same_stage || step.fraction >= reported_->fraction + kReportedStep;
  const bool completes = same_stage && step.fraction >= 1.0 && reported_->fraction < 1.0;
  if (!far_enough && !completes) return;
  reported_ = step;
  reports_.progress(step.stage, step.fraction);
}

void VolumeOpening::finish(OpenOutcome outcome) {
  withdraw();
  reports_.finished(std::move(outcome));
}

}  // namespace cutaway
