// The head of one HTTP/1 request: found among the bytes that came, checked, read.
#pragma once

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace cutaway {

/// No body is ever read into it.
using HttpRequest = boost::beast::http::request<boost::beast::http::empty_body>;

/// The longest head that is read, its blank line included.
inline constexpr std::size_t kHeadBytes = std::size_t{16} * 1024;

/// Looks for the end of a head, each byte once. What RFC 9112 lets a recipient repair and others
/// read in another way (lines that end in LF alone, folded lines, control characters, blanks before
/// the first field) is malformed here: who disagrees about where a request ends can be made to
/// answer one that nobody sent.
class HeadScanner {
 public:
  enum class State { incomplete, complete, malformed };

  /// `bytes` is all that came of this request so far, its beginning as in the call before.
  State scan(std::string_view bytes);
  /// Of the head once it is complete, the empty line that may come before it included.
  std::size_t length() const { return scanned_; }

 private:
  State step(char c);
  State end_line();

  std::size_t scanned_ = 0;
  std::size_t lines_ = 0;
  std::size_t line_bytes_ = 0;
  bool after_return_ = false;
  bool had_empty_line_ = false;
};

/// Why a request is not answered as it was meant.
struct HeadRefusal {
  boost::beast::http::status status;
  std::string reason;
};

/// Reads a complete head (RFC 9112, 2 to 6): one Host of sound syntax, a framing that all
/// recipients read alike, a target in origin-form; an absolute one is brought into it, its
/// authority replacing Host (3.2.2).
std::variant<HttpRequest, HeadRefusal> read_head(std::string_view head);

/// Is there a body longer than `most` bytes, or one whose length its head does not tell?
bool announces_body_over(const HttpRequest& request, std::uint64_t most);

/// Nothing but a host and perhaps a port that is a number (RFC 9110, 7.2).
bool is_host_and_port(std::string_view host);

}  // namespace cutaway
