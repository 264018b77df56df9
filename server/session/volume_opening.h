// One wish to open a volume, from the message to its outcome.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "session/volume_library.h"
#include "session/weak_callbacks.h"

namespace cutaway {

/// Lives on the session's strand. A new wish withdraws the one before; what is withdrawn reports
/// nothing more.
class VolumeOpening {
 public:
  struct Reports {
    /// At each stage's begin and end and about every twentieth of it.
    std::function<void(LoadStage, double)> progress;
    std::function<void(OpenOutcome)> finished;
  };

  VolumeOpening(std::shared_ptr<Strand> strand, VolumeLibrary& library, Reports reports);

  void begin(const std::string& id);
  void withdraw();
  /// The volume that is being opened.
  const std::optional<std::string>& volume() const { return volume_; }

 private:
  struct Step {
    LoadStage stage;
    double fraction;
  };

  ProgressSink relay();
  void progressed(Step step);
  void finish(OpenOutcome outcome);

  std::shared_ptr<Strand> strand_;
  VolumeLibrary& library_;
  Reports reports_;
  WeakCallbacks callbacks_;
  std::optional<std::string> volume_;
  std::optional<Step> reported_;
  std::unique_ptr<OpenTicket> ticket_;
};

}  // namespace cutaway
