// What a plain HTTP request gets.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <functional>
#include <string>

#include "net/request_head.h"
#include "net/static_files.h"
#include "scene/json.h"

namespace cutaway {

using HttpResponse = boost::beast::http::response<boost::beast::http::string_body>;

/// Thread-safe as far as its functions are.
class HttpAnswers {
 public:
  struct Sources {
    std::function<Json()> volumes;  ///< the content of the `volumes` message
    std::function<std::string()>
        trouble;  ///< why no frame can be rendered; empty while all is well
    std::function<bool()> full = [] { return false; };  ///< whether all sessions are taken
  };

  HttpAnswers(StaticFiles files, Sources sources);

  /// The whole response to GET, or to HEAD with its body left out.
  HttpResponse answer(const HttpRequest& request) const;
  /// The largest body that this request may have, bytes.
  std::uint64_t largest_body(const HttpRequest& request) const;
  /// 405, to a request of another method than the `allowed`, a list as in Allow. The connection
  /// ends with it where a body follows.
  static HttpResponse method_refusal(const HttpRequest& request, const std::string& allowed);
  /// For a request that is not heeded; the connection ends with it.
  static HttpResponse refusal(boost::beast::http::status status, std::string_view reason);

 private:
  struct Route;
  static const Route* find_route(std::string_view path);
  HttpResponse answer_get(const HttpRequest& request, std::string_view path) const;
  HttpResponse liveness() const;
  HttpResponse listing() const;
  HttpResponse file_response(const HttpRequest& request, const StaticFile& file) const;
  HttpResponse readiness() const;

  StaticFiles files_;
  Sources sources_;
};

/// The path of a request target, percent-decoded, without its query. Nothing where that is not a
/// clean absolute path (bad escapes, control characters, backslashes, a ".." segment).
std::optional<std::string> clean_path(std::string_view target);

}  // namespace cutaway
