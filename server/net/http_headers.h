// Headers that every response carries.
#pragma once

#include <boost/beast/http/field.hpp>

namespace cutaway {

/// What the page may load and run: its own files. Pictures come as blobs over the WebSocket, icons
/// as data; component libraries set styles from script.
inline constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' blob: "
    "data:; font-src 'self'; connect-src 'self' data:; worker-src 'self' blob:; manifest-src "
    "'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

template <typename Fields>
void set_security_headers(Fields& fields) {
  using boost::beast::http::field;
  fields.set(field::server, "cutaway");
  fields.set("Content-Security-Policy", kContentSecurityPolicy);
  fields.set("X-Content-Type-Options", "nosniff");
  fields.set("Referrer-Policy", "no-referrer");
  fields.set("Cross-Origin-Opener-Policy", "same-origin");
  fields.set("Cross-Origin-Resource-Policy", "same-origin");
}

}  // namespace cutaway
