// Books inputs and frames: which frame shows something new, which one is stale, which still was
// waited for.
#pragma once

#include <cstdint>
#include <optional>

#include "load/frame_header.h"
#include "load/record.h"

namespace cutaway::load {

/// Knows no clock and no socket; times are those of the record.
class Ledger {
 public:
  explicit Ledger(Record& record) : record_(record) {}

  /// An input of a movement was sent; one that comes more than `pause_s` later begins another
  /// movement.
  void moved(double at_s, double pause_s);
  /// The movement that this input belongs to ends with it; its still frame is awaited. Another
  /// movement before it comes makes it void.
  void rested(std::uint32_t input, double at_s);
  /// A live frame of so many bytes has arrived.
  void arrived(const FrameHeader& frame, std::size_t bytes, double at_s);

 private:
  struct Awaited {
    std::uint32_t input;
    double since_s;
  };

  bool is_stale(const FrameHeader& frame) const;
  void settle_still(const FrameHeader& frame, double at_s);
  bool moving(double at_s) const;

  Record& record_;
  std::optional<std::uint32_t> last_number_;
  std::uint32_t last_input_ = 0;
  std::optional<Awaited> awaited_;
  double moving_until_s_ = -1.0;
};

}  // namespace cutaway::load
