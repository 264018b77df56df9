#include "session/unseen_watch.h"

#include <algorithm>
#include <utility>

#include "scene/unseen.h"

namespace cutaway {

namespace {

constexpr std::chrono::milliseconds kRest{400};
constexpr std::chrono::seconds kBetweenLooks{1};

}  // namespace

UnseenWatch::UnseenWatch(const std::shared_ptr<Strand>& strand, Tell tell)
    : strand_(strand), tell_(std::move(tell)), alarm_(strand->make_alarm([this] { look(); })) {}

void UnseenWatch::changed(std::shared_ptr<const Scene> scene,
                          std::shared_ptr<const OpenVolume> volume) {
  scene_ = std::move(scene);
  volume_ = std::move(volume);
  TimePoint due = strand_->now() + kRest;
  if (looked_at_) due = std::max(due, *looked_at_ + kBetweenLooks);
  alarm_->set(due);
}

void UnseenWatch::look() {
  looked_at_ = strand_->now();
  if (!scene_ || !volume_) return;
  std::vector<UnseenReason> reasons = reasons_for_nothing(*scene_, volume_->facts());
  if (reasons == told_) return;
  told_ = std::move(reasons);
  tell_(told_);
}

}  // namespace cutaway
