#include "net/http_answers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "net/header_text.h"
#include "net/http_headers.h"

namespace cutaway {

namespace http = boost::beast::http;

namespace {

constexpr const char* kImmutable = "public, max-age=31536000, immutable";
constexpr const char* kRevalidate = "no-cache";

HttpResponse text_response(http::status status, std::string text, std::string_view type) {
  HttpResponse response;
  response.result(status);
  response.set(http::field::content_type, boost::beast::string_view(type.data(), type.size()));
  response.set(http::field::cache_control, "no-store");
  response.body() = std::move(text);
  return response;
}

HttpResponse plain(http::status status, std::string text) {
  return text_response(status, std::move(text) + "\n", "text/plain; charset=utf-8");
}

HttpResponse json(http::status status, const Json& content) {
  return text_response(status, content.dump(), "application/json");
}

HttpResponse not_found(bool has_client) {
  return plain(http::status::not_found,
               has_client ? "There is nothing at this path."
                          : "The web client is not built or its folder is not configured.");
}

// In a list such as If-None-Match or Accept-Encoding: the parameters after this item's ';', nothing
// where it is not listed.
std::optional<std::string_view> parameters_of(std::string_view item, std::string_view header) {
  while (!header.empty()) {
    const std::size_t comma = std::min(header.find(','), header.size());
    const std::string_view entry = trimmed_text(header.substr(0, comma));
    const std::size_t semicolon = std::min(entry.find(';'), entry.size());
    if (trimmed_text(entry.substr(0, semicolon)) == item) {
      return trimmed_text(entry.substr(std::min(semicolon + 1, entry.size())));
    }
    header.remove_prefix(std::min(comma + 1, header.size()));
  }
  return std::nullopt;
}

bool accepts_gzip(std::string_view header) {
  const auto parameters = parameters_of("gzip", header);
  if (!parameters) return false;
  return !parameters->starts_with("q=0") ||
         parameters->find_first_of("123456789") != std::string_view::npos;
}

void strip_body_for_head(const HttpRequest& request, HttpResponse& response) {
  const std::size_t length = response.body().size();
  if (request.method() == http::verb::head) {
    response.body().clear();
    response.content_length(length);
    return;
  }
  if (response.result() != http::status::not_modified) response.prepare_payload();
}

}  // namespace

HttpAnswers::HttpAnswers(StaticFiles files, Sources sources)
    : files_(std::move(files)), sources_(std::move(sources)) {}

HttpResponse HttpAnswers::answer(const HttpRequest& request) const {
  HttpResponse response;
  const auto path = clean_path(view_of(request.target()));
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    response = plain(http::status::method_not_allowed, "Only GET and HEAD are answered here.");
    response.set(http::field::allow, "GET, HEAD");
  } else if (!path) {
    response = plain(http::status::bad_request, "The path of the request is malformed.");
  } else {
    response = answer_get(request, *path);
  }
  set_security_headers(response);
  response.version(request.version());
  response.keep_alive(request.keep_alive());
  strip_body_for_head(request, response);
  return response;
}

HttpResponse HttpAnswers::refusal(http::status status, std::string_view reason) {
  HttpResponse response = plain(status, std::string(reason));
  set_security_headers(response);
  response.keep_alive(false);
  response.prepare_payload();
  return response;
}

/// What is answered at a path of its own; all else are files, whose requests have no body either.
struct HttpAnswers::Route {
  std::string_view path;
  std::uint64_t largest_body;
  HttpResponse (HttpAnswers::*answer)() const;
};

const HttpAnswers::Route* HttpAnswers::find_route(std::string_view path) {
  static constexpr std::array<Route, 3> kRoutes = {{
      {"/healthz", 0, &HttpAnswers::liveness},
      {"/readyz", 0, &HttpAnswers::readiness},
      {"/api/volumes", 0, &HttpAnswers::listing},
  }};
  const auto found = std::ranges::find(kRoutes, path, &Route::path);
  return found == kRoutes.end() ? nullptr : &*found;
}

std::uint64_t HttpAnswers::largest_body(const HttpRequest& request) const {
  const auto path = clean_path(view_of(request.target()));
  const Route* route = path ? find_route(*path) : nullptr;
  return route == nullptr ? 0 : route->largest_body;
}

HttpResponse HttpAnswers::answer_get(const HttpRequest& request, std::string_view path) const {
  if (const Route* route = find_route(path)) return (this->*route->answer)();
  const StaticFile* file = files_.find(path);
  return file != nullptr ? file_response(request, *file) : not_found(!files_.empty());
}

HttpResponse HttpAnswers::liveness() const { return plain(http::status::ok, "alive"); }

HttpResponse HttpAnswers::listing() const { return json(http::status::ok, sources_.volumes()); }

// A full server is ready all the same: who asks for it here would take it away from those within.
HttpResponse HttpAnswers::readiness() const {
  const std::string trouble = sources_.trouble();
  if (trouble.empty()) {
    return json(http::status::ok, {{"ready", true}, {"full", sources_.full()}});
  }
  return json(http::status::service_unavailable, {{"ready", false}, {"reason", trouble}});
}

HttpResponse HttpAnswers::file_response(const HttpRequest& request, const StaticFile& file) const {
  HttpResponse response;
  response.set(http::field::etag, file.etag);
  response.set(http::field::vary, "Accept-Encoding");
  response.set(http::field::cache_control, file.immutable ? kImmutable : kRevalidate);
  if (parameters_of(file.etag, view_of(request[http::field::if_none_match]))) {
    response.result(http::status::not_modified);
    return response;
  }
  response.set(http::field::content_type, file.mime_type);
  if (!file.gzip_content.empty() && accepts_gzip(view_of(request[http::field::accept_encoding]))) {
    response.set(http::field::content_encoding, "gzip");
    response.body() = file.gzip_content;
  } else {
    response.body() = file.content;
  }
  return response;
}

namespace {

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    unsigned int code = 0;
    if (i + 2 >= text.size()) return std::nullopt;
    const char* digits = text.data() + i + 1;
    if (std::from_chars(digits, digits + 2, code, 16).ptr != digits + 2) return std::nullopt;
    decoded += static_cast<char>(code);
    i += 2;
  }
  return decoded;
}

bool is_unclean(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\'; }

}  // namespace

std::optional<std::string> clean_path(std::string_view target) {
  auto path = percent_decoded(target.substr(0, target.find('?')));
  if (!path || !path->starts_with('/')) return std::nullopt;
  if (std::ranges::any_of(*path, is_unclean)) return std::nullopt;
  if ((*path + "/").find("/../") != std::string::npos) return std::nullopt;
  return path;
}

}  // namespace cutaway
