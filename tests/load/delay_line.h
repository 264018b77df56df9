// Things that arrive some time after they were sent off, in their order.
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <optional>

#include "load/awaitable.h"
#include "load/link.h"

namespace cutaway::load {

/// For one taker at a time; everything on the executor's thread.
template <typename T>
class DelayLine {
 public:
  template <typename Executor>
  explicit DelayLine(const Executor& executor) : timer_(executor) {}

  /// `due` is not before that of the item before.
  void push(T item, TimePoint due) {
    items_.push_back({std::move(item), due});
    if (items_.size() == 1) timer_.cancel();
  }

  /// What has not arrived yet never will.
  void close() {
    closed_ = true;
    items_.clear();
    timer_.cancel();
  }

  /// Nothing more will be pushed.
  void finish() {
    finished_ = true;
    timer_.cancel();
  }

  /// The next item once it is due; nothing once the line is closed, or finished and empty.
  boost::asio::awaitable<std::optional<T>> pop() {
    while (!closed_ && !(finished_ && items_.empty())) {
      if (!items_.empty() && items_.front().due <= Clock::now()) {
        std::optional<T> item = std::move(items_.front().item);
        items_.pop_front();
        co_return item;
      }
      timer_.expires_at(items_.empty() ? TimePoint::max() : items_.front().due);
      boost::system::error_code woken;
      co_await timer_.async_wait(boost::asio::redirect_error(boost::asio::use_awaitable, woken));
    }
    co_return std::nullopt;
  }

 private:
  struct Item {
    T item;
    TimePoint due;
  };

  boost::asio::steady_timer timer_;
  std::deque<Item> items_;
  bool closed_ = false;
  bool finished_ = false;
};

}  // namespace cutaway::load
