// What is wrong with a load script.
#pragma once

#include <stdexcept>
#include <string>

namespace cutaway::load {

/// Thrown where a script cannot be used. `field` is a JSON pointer (RFC 6901) into it, `code` one
/// of the protocol's error codes.
class ScriptError : public std::runtime_error {
 public:
  struct Detail {
    std::string code;
    std::string field;
    std::string expected;
    std::string received;
  };

  explicit ScriptError(Detail detail)
      : std::runtime_error(in_words(detail)), detail_(std::move(detail)) {}

  const Detail& detail() const { return detail_; }

 private:
  static std::string in_words(const Detail& detail) {
    const std::string where = detail.field.empty() ? "the script" : detail.field;
    return where + ": expected " + detail.expected + "; came " + detail.received + " (" +
           detail.code + ")";
  }

  Detail detail_;
};

}  // namespace cutaway::load
