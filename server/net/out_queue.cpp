#include "net/out_queue.h"

#include <algorithm>
#include <utility>

namespace cutaway {

bool OutQueue::put_text(std::string text) { return put({std::move(text), false}); }

bool OutQueue::put_latest_text(std::string text) {
  std::erase_if(texts_, [this](const Text& waiting) {
    if (waiting.is_latest) waiting_text_bytes_ -= waiting.text.size();
    return waiting.is_latest;
  });
  return put({std::move(text), true});
}

bool OutQueue::put(Text text) {
  if (!texts_.empty() && waiting_text_bytes_ + text.text.size() > text_bytes_) return false;
  waiting_text_bytes_ += text.text.size();
  texts_.push_back(std::move(text));
  return true;
}

void OutQueue::put_frame(int view, std::vector<std::uint8_t> message, Done done) {
  Message newest{std::move(message), std::move(done)};
  const auto waiting = std::ranges::find(frames_, view, &Frame::view);
  if (waiting == frames_.end()) {
    frames_.push_back({view, std::move(newest)});
    return;
  }
  const Message old = std::exchange(waiting->message, std::move(newest));
  if (old.done) old.done(false);
}

void OutQueue::put_still(std::vector<std::uint8_t> message, Done done) {
  stills_.push_back({std::move(message), std::move(done), true});
}

std::optional<OutQueue::Message> OutQueue::take() {
  if (!texts_.empty()) {
    Message message{std::move(texts_.front().text), nullptr};
    texts_.pop_front();
    waiting_text_bytes_ -= std::get<std::string>(message.content).size();
    return message;
  }
  if (!frames_.empty()) {
    Message frame = std::move(frames_.front().message);
    frames_.pop_front();
    return frame;
  }
  if (stills_.empty()) return std::nullopt;
  Message still = std::move(stills_.front());
  stills_.pop_front();
  return still;
}

void OutQueue::abandon() {
  texts_.clear();
  waiting_text_bytes_ = 0;
  for (const Frame& frame : std::exchange(frames_, {}))
    if (frame.message.done) frame.message.done(false);
  for (const Message& still : std::exchange(stills_, {}))
    if (still.done) still.done(false);
}

}  // namespace cutaway
