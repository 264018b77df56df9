// One element of a GLSL array of structs, whose members are set by name.
#pragma once

#include <string>

#include "gl/program.h"

namespace cutaway {

/// `UniformStruct(program, "tone", 1).set("detail", 0.5F)` sets tone[1].detail.
class UniformStruct {
 public:
  UniformStruct(const gl::Program& program, const std::string& array, std::size_t index)
      : program_(program), prefix_(array + "[" + std::to_string(index) + "].") {}

  template <typename Value>
  void set(const char* member, const Value& value) const {
    program_.set((prefix_ + member).c_str(), value);
  }

 private:
  const gl::Program& program_;
  std::string prefix_;
};

}  // namespace cutaway
