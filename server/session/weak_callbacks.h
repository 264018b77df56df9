// Weak callbacks: they come from other threads to an object that may be gone by then.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "session/strand.h"

namespace cutaway {

/// Belongs to an object that lives on a strand and is destroyed there. What it binds may be called
/// from any thread and at any time: it runs on the strand, and no more once this object is gone or
/// has revoked it.
class WeakCallbacks {
 public:
  explicit WeakCallbacks(std::shared_ptr<Strand> strand) : strand_(std::move(strand)) {}

  /// Nothing bound so far runs from now on.
  void revoke() { life_ = std::make_shared<char>(); }

  template <typename Argument>
  std::function<void(Argument)> bind(std::function<void(Argument)> work) const {
    return [strand = strand_, life = std::weak_ptr<char>(life_), work](Argument argument) {
      strand->post([life, work, argument = std::move(argument)]() mutable {
        if (life.lock()) work(std::move(argument));
      });
    };
  }

 private:
  std::shared_ptr<Strand> strand_;
  std::shared_ptr<char> life_ = std::make_shared<char>();
};

}  // namespace cutaway
