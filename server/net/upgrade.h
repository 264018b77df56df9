// May this request become a session?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "net/http_answers.h"
#include "scene/server_message.h"

namespace cutaway {

inline constexpr const char* kWebSocketPath = "/ws";

/// True for the path of the WebSocket, upgrade asked for or not.
bool is_web_socket_request(const HttpRequest& request);

/// The response that refuses the upgrade that a GET asks for: 426 where no upgrade or no
/// subprotocol that we speak is asked for, 403 for a page of another origin. Nothing where the
/// upgrade may go on.
std::optional<HttpResponse> refuse_upgrade(const HttpRequest& request,
                                           const std::vector<std::string>& allowed_origins);

/// A request without Origin comes from no browser page; else its host and port must be those that
/// the request was sent to, or the whole of it must be in the list.
bool origin_allowed(std::string_view origin, std::string_view host,
                    const std::vector<std::string>& allowed_origins);

}  // namespace cutaway
