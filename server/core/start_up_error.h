// What keeps the program from starting; no client ever hears of it.
#pragma once

#include <stdexcept>
#include <string>

namespace cutaway {

class StartUpError : public std::runtime_error {
 public:
  enum class Fault { renderer_unavailable, shader_error };

  StartUpError(Fault fault, const std::string& words) : std::runtime_error(words), fault_(fault) {}
  Fault fault() const noexcept { return fault_; }

 private:
  Fault fault_;
};

}  // namespace cutaway
