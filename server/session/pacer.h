// When the next frame is due, and of which kind.
#pragma once

#include <optional>

#include "session/strand.h"

namespace cutaway {

/// `finished`: the still once more, with what takes longer.
enum class FrameKind { interactive, still, finished };

/// Remembers what has changed and what has been shown. A change is due as an interactive frame,
/// `interval` after the one before; once `rest` has passed without a change, one still frame is
/// due, and after it a finished one where that is wanted; then nothing is.
class Pacer {
 public:
  explicit Pacer(Milliseconds rest) : rest_(rest) {}

  /// The scene is another one now; whether a still leaves something of it to finish.
  void changed(TimePoint now, bool has_finish = false);
  /// A frame of this kind with the newest scene has been asked for.
  void asked(FrameKind kind, TimePoint now);
  /// The newest scene cannot be rendered: nothing is due until it changes.
  void give_up();
  /// At least this long between two interactive frames: what the link needs for one.
  void set_interval(Milliseconds interval) { interval_ = interval; }

  /// There is a change that no frame was asked for yet, due or not.
  bool has_change() const { return change_due_; }
  /// What a change would be shown as now.
  FrameKind kind(TimePoint now) const;
  std::optional<FrameKind> due(TimePoint now) const;
  /// When `due` will answer something without a further change; nothing where never or already.
  std::optional<TimePoint> next_due(TimePoint now) const;

 private:
  TimePoint interactive_due() const;
  TimePoint still_due() const;

  Milliseconds rest_;
  Milliseconds interval_{0.0};
  bool change_due_ = false;
  bool still_due_ = false;
  bool finish_due_ = false;
  TimePoint last_change_;
  std::optional<TimePoint> last_asked_;
};

}  // namespace cutaway
