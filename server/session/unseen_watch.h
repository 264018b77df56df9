// Tells the client why its 3-D picture shows nothing, where it expects something.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "scene/server_message.h"
#include "session/strand.h"
#include "session/volume_library.h"

namespace cutaway {

/// Looks when the scene rests, and once a second at most: some hundred rays through a volume take
/// time on the thread that all sessions share. Lives on the session's strand.
class UnseenWatch {
 public:
  using Tell = std::function<void(const std::vector<UnseenReason>&)>;

  /// `tell` hears of reasons that differ from those that it heard before; of none, where they are
  /// over.
  UnseenWatch(const std::shared_ptr<Strand>& strand, Tell tell);

  /// The 3-D picture is now of this.
  void changed(std::shared_ptr<const Scene> scene, std::shared_ptr<const OpenVolume> volume);

 private:
  void look();

  std::shared_ptr<Strand> strand_;
  Tell tell_;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const OpenVolume> volume_;
  std::vector<UnseenReason> told_;
  std::optional<TimePoint> looked_at_;
  std::unique_ptr<Alarm> alarm_;
};

}  // namespace cutaway
