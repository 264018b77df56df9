// What all views of a session have on their way to its client: they share one link.
#pragma once

#include <cstddef>

namespace cutaway {

class LinkLoad {
 public:
  void sent(std::size_t bytes) { bytes_ += bytes; }
  void arrived(std::size_t bytes) { bytes_ -= bytes; }
  std::size_t bytes_in_flight() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

}  // namespace cutaway
