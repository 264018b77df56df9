#include "core/error.h"

#include <utility>

namespace cutaway {

namespace {

std::string sentence(const Error::Detail& detail) {
  std::string text = detail.message;
  if (!detail.field.empty()) text += " (" + detail.field + ")";
  if (!detail.expected.empty()) text += "; expected " + detail.expected;
  if (!detail.received.empty()) text += "; got " + detail.received;
  return text;
}

}  // namespace

Error::Error(Detail detail) : std::runtime_error(sentence(detail)), detail_(std::move(detail)) {}

}  // namespace cutaway
