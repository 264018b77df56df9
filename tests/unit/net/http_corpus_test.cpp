// What RFC 9112 and 9110 say of requests, sound and unsound: each as bytes over a socket, with the
// answers that are due and whether the connection goes on. After each the server serves the next.
#include <gtest/gtest.h>

#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include "unit/net/test_client.h"
#include "unit/net/test_server.h"

namespace cutaway {
namespace {

namespace http = boost::beast::http;
using Statuses = std::vector<unsigned>;

enum class Then { goes_on, ends };

struct Case {
  const char* name;
  std::string bytes;
  Statuses answers;
  Then then;
};

const std::string kHost = "Host: localhost\r\n";
const std::string kLast = "GET /healthz HTTP/1.1\r\n" + kHost + "Connection: close\r\n\r\n";

/// A request for /healthz with these further fields.
std::string get(const std::string& fields, const std::string& target = "/healthz") {
  return "GET " + target + " HTTP/1.1\r\n" + kHost + fields + "\r\n";
}

std::string post(const std::string& fields, const std::string& target = "/healthz") {
  return "POST " + target + " HTTP/1.1\r\n" + kHost + fields + "\r\n";
}

std::string with_host(const std::string& host_lines, const std::string& version = "1.1") {
  return "GET /healthz HTTP/" + version + "\r\n" + host_lines + "\r\n";
}

Statuses statuses_of(std::string_view answers) {
  Statuses statuses;
  while (!answers.empty()) {
    http::response_parser<http::string_body> parser;
    parser.eager(true);
    boost::system::error_code error;
    answers.remove_prefix(parser.put(boost::asio::buffer(answers.data(), answers.size()), error));
    if (error || !parser.is_done()) {
      ADD_FAILURE() << "this is no answer: " << answers;
      break;
    }
    statuses.push_back(parser.get().result_int());
    EXPECT_EQ(parser.get().result_int() == 405, !parser.get()["Allow"].empty()) << "(9110, 15.5.6)";
  }
  return statuses;
}

void expect_answers(std::uint16_t port, const Case& each) {
  SCOPED_TRACE(each.name);
  testing::RawClient client(port);
  client.send(each.bytes + (each.then == Then::goes_on ? kLast : ""));
  Statuses due = each.answers;
  if (each.then == Then::goes_on) due.push_back(200);
  const auto received = client.read_to_end();
  ASSERT_TRUE(received.has_value()) << "the connection did not end";
  EXPECT_EQ(statuses_of(*received), due) << *received;
  EXPECT_EQ(testing::fetch(port, "/healthz").result_int(), 200);
}

void expect_all(const std::vector<Case>& cases) {
  const testing::TestServer server;
  for (const Case& each : cases) expect_answers(server.port(), each);
}

TEST(HttpCorpus, Lines) {
  expect_all({
      {"a plain request", get(""), {200}, Then::goes_on},
      {"an empty line before it (9112, 2.2)", "\r\n" + get(""), {200}, Then::goes_on},
      {"two of them", "\r\n\r\n" + get(""), {400}, Then::ends},
      {"LF alone ends the lines", "GET / HTTP/1.1\nHost: localhost\n\n", {400}, Then::ends},
      {"LF alone in one line",
       "GET / HTTP/1.1\r\nHost: localhost\nX: y\r\n\r\n",
       {400},
       Then::ends},
      {"CR alone (2.2)", "GET / HTTP/1.1\r\nHost: localhost\rX: y\r\n\r\n", {400}, Then::ends},
      {"CR CR LF", "GET / HTTP/1.1\r\r\nHost: localhost\r\n\r\n", {400}, Then::ends},
      {"a folded line (5.2)", get("X: a\r\n b\r\n"), {400}, Then::ends},
      {"a blank before the first field (2.2)",
       "GET / HTTP/1.1\r\n " + kHost + "\r\n",
       {400},
       Then::ends},
      {"a blank before the colon (5.1)", get("Content-Length : 5\r\n"), {400}, Then::ends},
      {"a tab before the colon", get("X\t: 5\r\n"), {400}, Then::ends},
      {"a field without a colon", get("nonsense\r\n"), {400}, Then::ends},
      {"a field without a name", get(": nonsense\r\n"), {400}, Then::ends},
      {"a name that is no token", get("X(y): z\r\n"), {400}, Then::ends},
      {"NUL in a value", get(std::string("X: a\0b\r\n", 8)), {400}, Then::ends},
      {"DEL in a value", get("X: a\x7f\r\n"), {400}, Then::ends},
      {"bytes above 127 in a value (5.5)", get("X: \xC3\xA4\r\n"), {200}, Then::goes_on},
      {"an empty value", get("X:\r\n"), {200}, Then::goes_on},
      {"blanks around a value", get("X: \t a \t \r\n"), {200}, Then::goes_on},
  });
}

TEST(HttpCorpus, RequestLines) {
  expect_all({
      {"HTTP/0.9", "GET /\r\n\r\n", {400}, Then::ends},
      {"HTTP/1.0 ends", with_host(kHost, "1.0"), {200}, Then::ends},
      {"HTTP/1.0 kept alive",
       with_host(kHost + "Connection: keep-alive\r\n", "1.0"),
       {200},
       Then::goes_on},
      {"HTTP/2.0", with_host(kHost, "2.0"), {400}, Then::ends},
      {"HTTP/1.2", with_host(kHost, "1.2"), {400}, Then::ends},
      {"http/1.1 (2.3: case matters)", "GET / http/1.1\r\n" + kHost + "\r\n", {400}, Then::ends},
      {"HTTP/01.1", with_host(kHost, "01.1"), {400}, Then::ends},
      {"the preface of HTTP/2", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", {400}, Then::ends},
      {"a TLS hello", std::string("\x16\x03\x01\x02\x00\x01\x00\x01", 8), {400}, Then::ends},
      {"two blanks", "GET  / HTTP/1.1\r\n" + kHost + "\r\n", {400}, Then::ends},
      {"a tab for a blank", "GET\t/ HTTP/1.1\r\n" + kHost + "\r\n", {400}, Then::ends},
      {"something after the version", "GET / HTTP/1.1 x\r\n" + kHost + "\r\n", {400}, Then::ends},
      {"a method that is none", "G(T / HTTP/1.1\r\n" + kHost + "\r\n", {400}, Then::ends},
      {"a method that is not known", "BREW / HTTP/1.1\r\n" + kHost + "\r\n", {405}, Then::goes_on},
      {"get (9110, 9.1: case matters)",
       "get / HTTP/1.1\r\n" + kHost + "\r\n",
       {405},
       Then::goes_on},
      {"OPTIONS * (3.2.4)", "OPTIONS * HTTP/1.1\r\n" + kHost + "\r\n", {405}, Then::goes_on},
      {"CONNECT (3.2.3)",
       "CONNECT localhost:80 HTTP/1.1\r\n" + kHost + "\r\n",
       {405},
       Then::goes_on},
      {"a target that is none", "GET healthz HTTP/1.1\r\n" + kHost + "\r\n", {400}, Then::goes_on},
      {"a target of 9000 bytes", get("", "/" + std::string(9000, 'a')), {404}, Then::goes_on},
      {"a target that is too long (3)", "GET /" + std::string(20'000, 'a'), {414}, Then::ends},
      {"a header that is too long",
       get("X: " + std::string(20'000, 'a') + "\r\n"),
       {431},
       Then::ends},
      {"many small fields",
       "GET / HTTP/1.1\r\n" + kHost + std::string(20'000, 'a'),
       {431},
       Then::ends},
  });
}

TEST(HttpCorpus, Hosts) {
  expect_all({
      {"none (3.2)", with_host(""), {400}, Then::ends},
      {"none in HTTP/1.0", with_host("", "1.0"), {421}, Then::ends},
      {"two", with_host(kHost + "Host: localhost\r\n"), {400}, Then::ends},
      {"two that differ", with_host("Host: evil.example\r\n" + kHost), {400}, Then::ends},
      {"two in other letters", with_host(kHost + "hOST: evil.example\r\n"), {400}, Then::ends},
      {"a port", with_host("Host: localhost:8080\r\n"), {200}, Then::goes_on},
      {"an empty port", with_host("Host: localhost:\r\n"), {200}, Then::goes_on},
      {"a port that is no number", with_host("Host: localhost:80x\r\n"), {400}, Then::ends},
      {"a negative port", with_host("Host: localhost:-1\r\n"), {400}, Then::ends},
      {"a port over 65535", with_host("Host: localhost:65536\r\n"), {400}, Then::ends},
      {"two ports", with_host("Host: localhost:80:80\r\n"), {400}, Then::ends},
      {"a user", with_host("Host: me@localhost\r\n"), {400}, Then::ends},
      {"a path", with_host("Host: localhost/x\r\n"), {400}, Then::ends},
      {"a list", with_host("Host: localhost, evil.example\r\n"), {400}, Then::ends},
      {"blanks within", with_host("Host: local host\r\n"), {400}, Then::ends},
      {"IPv6", with_host("Host: [::1]:80\r\n"), {200}, Then::goes_on},
      {"IPv6 without brackets", with_host("Host: ::1\r\n"), {400}, Then::ends},
      {"an open bracket", with_host("Host: [::1\r\n"), {400}, Then::ends},
      {"something after the bracket", with_host("Host: [::1]x\r\n"), {400}, Then::ends},
      {"an empty one", with_host("Host:\r\n"), {421}, Then::ends},
      {"another's", with_host("Host: evil.example\r\n"), {421}, Then::ends},
      {"another's, with a body",
       with_host("Host: evil.example\r\nContent-Length: 9\r\n"),
       {421},
       Then::ends},
      {"another's, POST with a body",
       "POST /healthz HTTP/1.1\r\nHost: evil.example\r\nContent-Length: 5\r\n\r\nhello",
       {421},
       Then::ends},
      {"an absolute target (3.2.2)", get("", "http://localhost:80/healthz"), {200}, Then::goes_on},
      {"its host counts, not Host", get("", "http://evil.example/healthz"), {421}, Then::ends},
      {"and not Host",
       "GET http://127.0.0.1/healthz HTTP/1.1\r\nHost: evil.example\r\n\r\n",
       {200},
       Then::goes_on},
      {"an absolute target without a path", get("", "HTTP://localhost"), {404}, Then::goes_on},
      {"an absolute target without a host", get("", "http:///healthz"), {400}, Then::ends},
      {"an absolute target with a user", get("", "http://a@localhost/"), {400}, Then::ends},
      {"another scheme", get("", "ftp://localhost/healthz"), {400}, Then::goes_on},
  });
}

// What is left of a body must not be taken for the next request: who announces one is not read on.
TEST(HttpCorpus, Framing) {
  const std::string smuggled = "GET /readyz HTTP/1.1\r\n" + kHost + "\r\n";
  const std::string chunked = "Transfer-Encoding: chunked\r\n";
  expect_all({
      {"no bytes", get("Content-Length: 0\r\n"), {200}, Then::goes_on},
      {"POST of no bytes", post("Content-Length: 0\r\n"), {405}, Then::goes_on},
      {"POST of some bytes", post("Content-Length: 5\r\n") + "hello", {405}, Then::ends},
      {"POST of a request", post("Content-Length: 40\r\n") + smuggled, {405}, Then::ends},
      {"POST of chunks", post(chunked) + "0\r\n\r\n" + smuggled, {405}, Then::ends},
      {"POST where a WebSocket is", post("Content-Length: 1\r\n", "/ws") + "x", {405}, Then::ends},
      {"POST of two lengths",
       post("Content-Length: 0\r\nContent-Length: 40\r\n") + smuggled,
       {400},
       Then::ends},
      {"one byte", get("Content-Length: 1\r\n") + "x", {413}, Then::ends},
      {"a request for a body", get("Content-Length: 40\r\n") + smuggled, {413}, Then::ends},
      {"more than there is", get("Content-Length: 99999999999\r\n"), {413}, Then::ends},
      {"2^64", get("Content-Length: 18446744073709551616\r\n"), {400}, Then::ends},
      {"a negative length", get("Content-Length: -1\r\n"), {400}, Then::ends},
      {"a length with a sign", get("Content-Length: +1\r\n"), {400}, Then::ends},
      {"a hexadecimal length", get("Content-Length: 0x1\r\n"), {400}, Then::ends},
      {"an empty length", get("Content-Length:\r\n"), {400}, Then::ends},
      {"a list of lengths", get("Content-Length: 0, 0\r\n"), {400}, Then::ends},
      {"two lengths",
       get("Content-Length: 0\r\nContent-Length: 40\r\n") + smuggled,
       {400},
       Then::ends},
      {"two lengths alike", get("Content-Length: 0\r\nContent-Length: 0\r\n"), {400}, Then::ends},
      {"chunks", get(chunked) + "1\r\nx\r\n0\r\n\r\n", {413}, Then::ends},
      {"no chunk", get(chunked) + "0\r\n\r\n" + smuggled, {413}, Then::ends},
      {"chunks and a length (6.1)",
       get("Content-Length: 5\r\n" + chunked) + "0\r\n\r\n" + smuggled,
       {400},
       Then::ends},
      {"a length and chunks",
       get(chunked + "Content-Length: 5\r\n") + "0\r\n\r\n",
       {400},
       Then::ends},
      {"chunks twice", get(chunked + chunked) + "0\r\n\r\n", {400}, Then::ends},
      {"an unknown coding (6.1)", get("Transfer-Encoding: gzip\r\n"), {501}, Then::ends},
      {"chunks within", get("Transfer-Encoding: chunked, identity\r\n"), {501}, Then::ends},
      {"a mark after it", get("Transfer-Encoding: chunked\x0b\r\n"), {400}, Then::ends},
      {"a blank before the colon", get("Transfer-Encoding : chunked\r\n"), {400}, Then::ends},
      {"chunks in HTTP/1.0", with_host(kHost + chunked, "1.0"), {400}, Then::ends},
      {"Expect and a body (9110, 10.1.1)",
       get("Content-Length: 5\r\nExpect: 100-continue\r\n"),
       {413},
       Then::ends},
      {"Expect without a body", get("Expect: 100-continue\r\n"), {200}, Then::goes_on},
      {"three at once",
       get("") + get("", "/readyz") + get("", "/nowhere"),
       {200, 200, 404},
       Then::goes_on},
      {"one at once, and garbage", get("") + "\x01garbage\r\n\r\n", {200, 400}, Then::ends},
      {"Connection: close, and more", get("Connection: close\r\n") + smuggled, {200}, Then::ends},
      {"a WebSocket's body", get("Content-Length: 5\r\n", "/ws"), {413}, Then::ends},
      {"a frame before the answer",
       get("Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
           "Sec-WebSocket-Protocol: cutaway.v1\r\n",
           "/ws") +
           "\x81\x80\x01\x02\x03\x04",
       {400},
       Then::ends},
      {"a WebSocket of another version",
       get("Upgrade: websocket\r\nConnection: Upgrade\r\n"
           "Sec-WebSocket-Version: 8\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n",
           "/ws"),
       {426},
       Then::ends},
  });
}

// Byte by byte, as from a slow client: the same answer.
TEST(HttpCorpus, ARequestInSinglebytesIsTheSame) {
  const testing::TestServer server;
  testing::RawClient client(server.port());
  for (const char byte : get("Connection: close\r\n")) client.send(std::string(1, byte));
  EXPECT_EQ(statuses_of(client.read_to_end().value()), Statuses{200});
}

// A refusal reaches a client that is still sending.
TEST(HttpCorpus, WhoSendsABodyHearsThatItIsNotTaken) {
  const testing::TestServer server;
  testing::RawClient client(server.port());
  client.send(get("Content-Length: 200000\r\n") + std::string(200'000, 'x'));
  EXPECT_EQ(statuses_of(client.read_to_end().value()), Statuses{413});
}

}  // namespace
}  // namespace cutaway
