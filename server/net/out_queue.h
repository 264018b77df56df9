// What waits to be written to one client, with a bound on each kind.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cutaway {

/// Texts in their order, then the waiting frames, one of each view, then stills and previews in
/// their order (a session has at most one of each under way). Not thread-safe.
class OutQueue {
 public:
  using Done = std::function<void(bool)>;
  struct Message {
    std::variant<std::string, std::vector<std::uint8_t>> content;
    Done done;              ///< empty for a text
    bool is_still = false;  ///< or a preview: may be large, and is waited for
  };

  explicit OutQueue(std::size_t text_bytes) : text_bytes_(text_bytes) {}

  /// False, and nothing taken, where others wait already and the bound would be exceeded: one text
  /// of any length is no sign of a client that does not read.
  [[nodiscard]] bool put_text(std::string text);
  /// The same for a text that makes those of its kind that wait worthless: they are dropped.
  [[nodiscard]] bool put_latest_text(std::string text);
  /// Replaces the view's frame that waits, in its place; that one's `done` gets false.
  void put_frame(int view, std::vector<std::uint8_t> message, Done done);
  void put_still(std::vector<std::uint8_t> message, Done done);

  std::optional<Message> take();
  /// Nothing more will be written: every `done` that waits gets false.
  void abandon();

 private:
  struct Text {
    std::string text;
    bool is_latest;
  };
  struct Frame {
    int view;
    Message message;
  };
  bool put(Text text);

  std::size_t text_bytes_;
  std::size_t waiting_text_bytes_ = 0;
  std::deque<Text> texts_;
  std::deque<Frame> frames_;
  std::deque<Message> stills_;
};

}  // namespace cutaway
