#include "scene/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"

namespace cutaway {

namespace {

constexpr int kNumberOverflow = 406;  // nlohmann's id of the exception

/// Builds the document while it is read and knows where it is, for error messages.
class DocumentBuilder : public nlohmann::json_sax<Json> {
 public:
  Json take() { return std::move(root_); }

  bool null() override { return place(nullptr); }
  bool boolean(bool value) override { return place(value); }
  bool number_integer(number_integer_t value) override { return place(value); }

  /// Beyond 63 bits as a float, so that every integer of a document is a signed one.
  bool number_unsigned(number_unsigned_t value) override {
    constexpr auto kLargest = std::numeric_limits<number_integer_t>::max();
    if (value > number_unsigned_t{kLargest}) return place(static_cast<number_float_t>(value));
    return place(static_cast<number_integer_t>(value));
  }

  bool string(string_t& value) override { return place(std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool number_float(number_float_t value, const string_t&) override {
    constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
    if (std::abs(value) <= kExactIntegers && std::trunc(value) == value)
      return place(static_cast<number_integer_t>(value));
    return place(value);
  }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    open_.back().key = std::move(value);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& exception) override {
    if (exception.id == kNumberOverflow) refuse_number(exception.what());
    const std::string what = exception.what();
    throw Error({.code = ErrorCode::malformed_json,
                 .message = "not JSON, byte " + std::to_string(position) + ": " +
                            shortened(what.substr(what.find("] ") + 2), 160),
                 .expected = "one JSON document in UTF-8"});
  }

 private:
  struct Level {
    Json* container;
    std::string key;
  };

  template <typename T>
  bool place(T&& value) {
    add(Json(std::forward<T>(value)));
    return true;
  }

  Json& add(Json value) {
    if (open_.empty()) return root_ = std::move(value);
    Json& container = *open_.back().container;
    if (container.is_object()) return container[open_.back().key] = std::move(value);
    container.push_back(std::move(value));
    return container.back();
  }

  bool open(Json empty) {
    if (open_.size() == kMaximumJsonDepth)
      throw Error({.code = ErrorCode::malformed_json,
                   .message = "nested too deeply",
                   .expected = "at most " + std::to_string(kMaximumJsonDepth) + " levels"});
    open_.push_back({&add(std::move(empty)), {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string here() const {
    std::string pointer;
    for (const Level& level : open_)
      pointer = level.container->is_object() ? pointer_to(pointer, level.key)
                                             : pointer_to(pointer, deeper_index(level));
    return pointer;
  }

  /// The element being read is already in the array where it is itself a container.
  std::size_t deeper_index(const Level& level) const {
    const bool innermost = &level == &open_.back();
    return innermost ? level.container->size() : level.container->size() - 1;
  }

  [[noreturn]] void refuse_number(const std::string& what) const {
    throw Error({.code = ErrorCode::not_finite,
                 .message = "a number is too large",
                 .field = here(),
                 .expected = "a number that a 64-bit float holds",
                 .received = shortened(what.substr(what.rfind(' ') + 1), 40)});
  }

  Json root_;
  std::vector<Level> open_;
};

constexpr std::string_view kNumberBytes = "+-.0123456789Ee";

std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return at + 1;
}

bool is_held(std::string_view number) {
  double value = 0.0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  return read.ec != std::errc::result_out_of_range;
}

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

Json parse_json(std::string_view text) {
  DocumentBuilder builder;
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

std::string with_numbers_held(std::string text) {
  std::size_t at = 0;
  while (at < text.size()) {
    if (text[at] == '"') {
      at = end_of_string(text, at);
      continue;
    }
    const std::size_t end = std::min(text.find_first_not_of(kNumberBytes, at), text.size());
    if (end > at && !is_held(std::string_view(text).substr(at, end - at))) {
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(at),
                text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
      text[at] = '0';
    }
    at = std::max(end, at + 1);
  }
  return text;
}

std::string json_text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string shortened(std::string text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && continues_character(text[bytes])) --bytes;
  text.resize(bytes);
  return text + "...";
}

std::string pointer_to(const std::string& pointer, std::string_view key) {
  std::string result = pointer + '/';
  for (const char c : key) {
    if (c == '~')
      result += "~0";
    else if (c == '/')
      result += "~1";
    else
      result += c;
  }
  return result;
}

std::string pointer_to(const std::string& pointer, std::size_t index) {
  return pointer + '/' + std::to_string(index);
}

}  // namespace cutaway
