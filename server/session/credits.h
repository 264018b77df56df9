// How many more frames a session may have in flight.
#pragma once

#include "core/check.h"

namespace cutaway {

/// A frame takes one when it is asked for; acknowledgement, replacement, failure and cancel return
/// it.
class Credits {
 public:
  explicit Credits(int total) : total_(total), free_(total) {}

  int free() const { return free_; }

  bool take() {
    if (free_ == 0) return false;
    --free_;
    return true;
  }

  void give_back() {
    check(free_ < total_, "a credit is returned once");
    ++free_;
  }

 private:
  int total_;
  int free_;
};

}  // namespace cutaway
