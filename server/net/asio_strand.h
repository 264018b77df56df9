// A session's strand on an Asio executor.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/strand.hpp>

#include "session/strand.h"

namespace cutaway {

class AsioStrand final : public Strand {
 public:
  using Executor = boost::asio::strand<boost::asio::io_context::executor_type>;

  explicit AsioStrand(Executor executor);

  TimePoint now() const override;
  void post(std::function<void()> work) override;
  std::unique_ptr<Alarm> make_alarm(std::function<void()> ring) override;

 private:
  Executor executor_;
};

}  // namespace cutaway
