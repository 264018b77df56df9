#include "net/upgrade.h"

#include <algorithm>
#include <boost/beast/http/rfc7230.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "net/header_text.h"

namespace cutaway {

namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;

namespace {

bool offers_our_subprotocol(const HttpRequest& request) {
  http::token_list offered(request[http::field::sec_websocket_protocol]);
  return offered.exists(kSubprotocol);
}

HttpResponse upgrade_required(const std::string& reason) {
  HttpResponse response = HttpAnswers::refusal(http::status::upgrade_required, reason);
  response.set(http::field::upgrade, "websocket");
  response.set(http::field::sec_websocket_protocol, kSubprotocol);
  return response;
}

}  // namespace

bool is_web_socket_request(const HttpRequest& request) {
  return clean_path(view_of(request.target())) == kWebSocketPath;
}

std::optional<HttpResponse> refuse_upgrade(const HttpRequest& request,
                                           const std::vector<std::string>& allowed_origins) {
  const std::string speaks = std::string("It speaks the subprotocol ") + kSubprotocol + ".";
  if (request.method() != http::verb::get) {
    HttpResponse response =
        HttpAnswers::refusal(http::status::method_not_allowed, "A WebSocket begins with GET.");
    response.set(http::field::allow, "GET");
    return response;
  }
  if (!websocket::is_upgrade(request)) {
    return upgrade_required("This path is a WebSocket (RFC 6455, version 13). " + speaks);
  }
  if (!offers_our_subprotocol(request)) {
    return upgrade_required("The server speaks none of the subprotocols offered. " + speaks);
  }
  if (!origin_allowed(view_of(request[http::field::origin]), view_of(request[http::field::host]),
                      allowed_origins)) {
    return HttpAnswers::refusal(http::status::forbidden,
                                "Pages of this origin may not open a session here; the "
                                "configuration's allowed_origins would have to list it.");
  }
  return std::nullopt;
}

bool origin_allowed(std::string_view origin, std::string_view host,
                    const std::vector<std::string>& allowed_origins) {
  if (origin.empty()) return true;
  if (std::ranges::find(allowed_origins, origin) != allowed_origins.end()) return true;
  const std::size_t scheme = origin.find("://");
  if (scheme == std::string_view::npos || host.empty()) return false;
  return boost::beast::iequals({origin.data() + scheme + 3, origin.size() - scheme - 3},
                               {host.data(), host.size()});
}

}  // namespace cutaway
