// What all connections share.
#pragma once

#include <atomic>
#include <cstdint>

#include "net/admission.h"
#include "net/client_address.h"
#include "net/connection_list.h"
#include "net/drop_log.h"
#include "net/http_answers.h"
#include "net/settings.h"
#include "net/web_socket.h"

namespace cutaway {

/// Outlives the connections. Any thread.
struct ConnectionContext {
  NetSettings settings;
  Admission admission;
  HttpAnswers answers;
  SessionFactory make_session;
  ClientAddresses addresses{settings.trusted_proxies, settings.limit_loopback};
  ConnectionList connections{settings.connections, settings.connections_per_address};
  DropLog drops;
  std::atomic<std::uint64_t> web_sockets{0};  ///< so far; numbers them in the log
};

}  // namespace cutaway
