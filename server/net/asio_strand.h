// A session's strand on an Asio executor.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/strand.hpp>
#include <functional>
#include <memory>

#include "session/strand.h"

namespace cutaway {

class AsioStrand final : public Strand {
 public:
  using Executor = boost::asio::strand<boost::asio::io_context::executor_type>;

  using Failed = std::function<void(const char* what)>;

  /// `failed` hears, on the strand, what each exception says that work or an alarm let out.
  AsioStrand(Executor executor, Failed failed);

  TimePoint now() const override;
  void post(std::function<void()> work) override;
  std::unique_ptr<Alarm> make_alarm(std::function<void()> ring) override;

 private:
  Executor executor_;
  std::shared_ptr<const Failed> failed_;
};

}  // namespace cutaway
