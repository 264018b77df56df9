// Plain HTTP over real sockets: files, status pages, and requests that are none.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "net/host_check.h"
#include "net/upgrade.h"
#include "unit/net/test_client.h"
#include "unit/net/test_server.h"

namespace cutaway {
namespace {

namespace fs = std::filesystem;
using testing::fetch;
using testing::RawClient;
using testing::SocketClient;
using testing::TestServer;

/// A web client's folder, next to a file that is not to be served.
class WebRoot {
 public:
  WebRoot() {
    write("site/index.html", "<!doctype html><title>Cutaway</title>");
    write("site/assets/index-abc123.js", "console.log('hello');");
    write("site/assets/index-abc123.js.gz", "pretend this is gzip");
    write("site/icon.svg", "<svg/>");
    write("site/with space.txt", "spaced");
    write("secret.txt", "secret");
    fs::create_symlink(folder_ / "secret.txt", folder_ / "site/leak.txt");
  }
  ~WebRoot() { fs::remove_all(folder_); }
  WebRoot(const WebRoot&) = delete;
  WebRoot& operator=(const WebRoot&) = delete;

  fs::path site() const { return folder_ / "site"; }

 private:
  void write(const std::string& name, const std::string& content) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << content;
  }

  fs::path folder_ = fs::temp_directory_path() / ("cutaway-http-test-" + std::to_string(getpid()));
};

NetSettings with_site(const fs::path& site) {
  NetSettings settings = testing::test_settings();
  settings.web_root = site;
  return settings;
}

class HttpTest : public ::testing::Test {
 protected:
  auto get(const std::string& target,
           const std::vector<std::pair<std::string, std::string>>& headers = {},
           const std::string& method = "GET") {
    return fetch(server.port(), target, headers, method);
  }

  WebRoot root;
  TestServer server{with_site(root.site())};
};

TEST_F(HttpTest, ServesTheWebClientWithItsTypes) {
  const auto page = get("/");
  EXPECT_EQ(page.result_int(), 200);
  EXPECT_EQ(page["Content-Type"], "text/html; charset=utf-8");
  EXPECT_NE(page.body().find("<title>Cutaway"), std::string::npos);
  EXPECT_EQ(get("/assets/index-abc123.js")["Content-Type"], "text/javascript; charset=utf-8");
  EXPECT_EQ(get("/icon.svg?v=1")["Content-Type"], "image/svg+xml");
  EXPECT_EQ(get("/with%20space.txt").body(), "spaced");
}

TEST_F(HttpTest, EveryAnswerCarriesTheSecurityHeaders) {
  for (const char* target : {"/", "/nowhere", "/healthz", "/api/volumes", "/ws", "/%zz"}) {
    const auto answer = get(target);
    EXPECT_EQ(answer["X-Content-Type-Options"], "nosniff") << target;
    EXPECT_NE(answer["Content-Security-Policy"].find("default-src 'none'"), std::string::npos)
        << target;
  }
}

TEST_F(HttpTest, AnUnchangedFileIsNotSentAgain) {
  const auto first = get("/icon.svg");
  const std::string etag(first["ETag"]);
  EXPECT_EQ(first["Cache-Control"], "no-cache");
  const auto second = get("/icon.svg", {{"If-None-Match", "\"other\", " + etag}});
  EXPECT_EQ(second.result_int(), 304);
  EXPECT_TRUE(second.body().empty());
  EXPECT_EQ(get("/icon.svg", {{"If-None-Match", "\"other\""}}).result_int(), 200);
}

TEST_F(HttpTest, NamesThatChangeWithTheirContentAreCachedForEver) {
  EXPECT_NE(get("/assets/index-abc123.js")["Cache-Control"].find("immutable"), std::string::npos);
}

TEST_F(HttpTest, SendsTheCompressedFileToThoseWhoTakeIt) {
  const auto compressed = get("/assets/index-abc123.js", {{"Accept-Encoding", "br, gzip;q=0.8"}});
  EXPECT_EQ(compressed["Content-Encoding"], "gzip");
  EXPECT_EQ(compressed.body(), "pretend this is gzip");
  const auto plain = get("/assets/index-abc123.js", {{"Accept-Encoding", "br, gzip;q=0.0"}});
  EXPECT_EQ(plain.count("Content-Encoding"), 0);
  EXPECT_EQ(plain.body(), "console.log('hello');");
}

TEST_F(HttpTest, HeadHasTheHeadersAndNoBody) {
  const auto answer = get("/icon.svg", {}, "HEAD");
  EXPECT_EQ(answer.result_int(), 200);
  EXPECT_EQ(answer["Content-Length"], "6");
  EXPECT_TRUE(answer.body().empty());
}

TEST_F(HttpTest, OtherMethodsAreRefused) {
  for (const char* method : {"POST", "PUT", "DELETE", "BREW"}) {
    const auto answer = get("/", {}, method);
    EXPECT_EQ(answer.result_int(), 405) << method;
    EXPECT_EQ(answer["Allow"], "GET, HEAD") << method;
  }
}

TEST_F(HttpTest, WhatIsNotThereIsNotFound) {
  EXPECT_EQ(get("/nowhere").result_int(), 404);
  EXPECT_EQ(get("/assets").result_int(), 404);
  EXPECT_EQ(get("/assets/index-abc123.js.gz").result_int(), 404);
}

TEST_F(HttpTest, NothingOutsideOfTheFolderIsReached) {
  for (const char* target :
       {"/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt",
        "/.%2e/secret.txt", "/assets/..\\..\\secret.txt", "//etc/passwd", "/%00", "/leak.txt",
        "/assets/%2e%2e/%2e%2e/secret.txt", "../secret.txt", "/%zz", "/%2"}) {
    const auto answer = get(target);
    EXPECT_TRUE(answer.result_int() == 400 || answer.result_int() == 404) << target;
    EXPECT_EQ(answer.body().find("secret"), std::string::npos) << target;
  }
}

TEST_F(HttpTest, SaysHowItIs) {
  EXPECT_EQ(get("/healthz").result_int(), 200);
  EXPECT_EQ(get("/readyz").result_int(), 200);
  server.in_trouble = true;
  EXPECT_EQ(get("/healthz").result_int(), 200);
  EXPECT_EQ(get("/readyz").result_int(), 503);
  EXPECT_EQ(Json::parse(get("/readyz").body())["reason"], "no GPU");
}

TEST_F(HttpTest, ListsTheVolumes) {
  const auto answer = get("/api/volumes");
  EXPECT_EQ(answer["Content-Type"], "application/json");
  EXPECT_EQ(Json::parse(answer.body())["volumes"][0]["id"], "ball");
}

TEST_F(HttpTest, SeveralRequestsShareAConnection) {
  RawClient client(server.port());
  client.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_NE(client.read_some().find("alive"), std::string::npos);
  client.send("GET /readyz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  const auto rest = client.read_to_end();
  ASSERT_TRUE(rest.has_value());
  EXPECT_NE(rest->find("ready"), std::string::npos);
}

TEST_F(HttpTest, GarbageGetsA400AndTheConnectionEnds) {
  for (const std::string& garbage :
       {std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", 15),
        std::string("hello\r\n\r\n"), std::string("GET\r\n\r\n"),
        std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nContent-Length: -4\r\n\r\n")}) {
    RawClient client(server.port());
    client.send(garbage);
    const auto answer = client.read_to_end();
    ASSERT_TRUE(answer.has_value());
    EXPECT_TRUE(answer->starts_with("HTTP/1.1 400 ")) << *answer;
  }
}

TEST_F(HttpTest, AHeaderOrBodyThatIsTooLongIsRefused) {
  RawClient header(server.port());
  header.send("GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(20'000, 'x') + "\r\n\r\n");
  EXPECT_TRUE(header.read_to_end().value().starts_with("HTTP/1.1 431 "));
  RawClient body(server.port());
  body.send("GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100000000\r\n\r\n");
  EXPECT_TRUE(body.read_to_end().value().starts_with("HTTP/1.1 413 "));
}

TEST(Http, SaysWhatIsMissingWhereThereIsNoWebClient) {
  TestServer server;
  const auto answer = fetch(server.port(), "/");
  EXPECT_EQ(answer.result_int(), 404);
  EXPECT_NE(answer.body().find("web client is not built"), std::string::npos);
}

TEST(Http, ASilentOrSlowConnectionIsClosed) {
  NetSettings settings = testing::test_settings();
  settings.request_timeout = std::chrono::milliseconds(200);
  TestServer server(settings);
  RawClient silent(server.port());
  RawClient slow(server.port());
  slow.send("GET / HTT");
  EXPECT_EQ(silent.read_to_end(), "");
  EXPECT_EQ(slow.read_to_end(), "");
}

TEST(Http, FiftySilentConnectionsDisturbNobody) {
  TestServer server;
  std::vector<std::unique_ptr<RawClient>> silent;
  silent.reserve(50);
  for (int i = 0; i < 50; ++i) silent.push_back(std::make_unique<RawClient>(server.port()));
  EXPECT_EQ(fetch(server.port(), "/healthz").result_int(), 200);
}

TEST(Http, ConnectionsBeyondTheLimitAreDroppedWhereNoneWaitsForARequest) {
  NetSettings settings = testing::test_settings();
  settings.connections = 3;
  TestServer server(settings);
  std::vector<std::unique_ptr<SocketClient>> taking;
  for (int i = 0; i < 3; ++i) {
    taking.push_back(std::make_unique<SocketClient>(server.port()));
    taking.back()->read_until("capabilities");
  }
  RawClient one_more(server.port());
  EXPECT_EQ(one_more.read_to_end(), "");
}

TEST(Http, AnAddressThatCannotBeHadIsAnErrorThatNamesIt) {
  TestServer server;
  NetSettings settings = testing::test_settings();
  settings.port = server.port();
  try {
    const Server second(settings, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().field, "127.0.0.1:" + std::to_string(server.port()));
    EXPECT_NE(error.detail().message.find("cannot listen"), std::string::npos);
  }
}

TEST(Host, OnALoopbackAddressIsThisMachineOrListed) {
  const NetSettings settings{
      .allowed_origins = {"https://viewer.example:8443", "http://[fd00::1]"}};
  for (const char* host : {"localhost", "LocalHost:8080", "127.0.0.1", "127.0.0.1:80", "[::1]",
                           "[::1]:9000", "viewer.example", "Viewer.example:1", "[fd00::1]:80"}) {
    EXPECT_TRUE(host_allowed(host, settings)) << host;
  }
  for (const char* host :
       {"", "evil.example", "evil.example:8080", "localhost.evil.example", "127.0.0.1.evil.example",
        "127.0.0.2", "viewer.example.evil", ":8080", "[::1", "::1", "[::1]evil"}) {
    EXPECT_FALSE(host_allowed(host, settings)) << host;
  }
}

TEST(Host, OnAnotherLoopbackAddressIsThatOneToo) {
  EXPECT_TRUE(host_allowed("127.0.0.5:8080", {.address = "127.0.0.5"}));
  EXPECT_FALSE(host_allowed("evil.example", {.address = "127.0.0.5"}));
  EXPECT_FALSE(host_allowed("evil.example", {.address = "::1"}));
}

TEST(Host, OnAnAddressThatOthersReachIsListedOrAnAddress) {
  const NetSettings unnamed{.address = "0.0.0.0"};
  for (const char* host : {"192.168.1.5", "192.168.1.5:8080", "[fd00::1]:80", "localhost"}) {
    EXPECT_TRUE(host_allowed(host, unnamed)) << host;
  }
  for (const char* host : {"viewer.example", "", "evil.example:80", "1.2.3", "[1.2.3.4]", "fd00::1",
                           "1.2.3.4.example"}) {
    EXPECT_FALSE(host_allowed(host, unnamed)) << host;
  }
  const NetSettings named{.address = "192.168.1.5", .hosts = {"viewer.example"}};
  EXPECT_TRUE(host_allowed("Viewer.Example:443", named));
  EXPECT_TRUE(host_allowed("192.168.1.5:80", named));
  EXPECT_FALSE(host_allowed("evil.example", named));
}

TEST(Host, OfTheListIsRightOnALoopbackAddressToo) {
  EXPECT_TRUE(host_allowed("viewer.example", {.hosts = {"viewer.example"}}));
  EXPECT_FALSE(host_allowed("192.168.1.5", {.hosts = {"viewer.example"}}));
}

TEST(Http, OnEveryAddressAStrangersNameIsRefused) {
  NetSettings settings = testing::test_settings();
  settings.address = "0.0.0.0";
  settings.hosts = {"viewer.example"};
  TestServer server(settings);
  const auto status = [&](const std::string& host) {
    return fetch(server.port(), "/healthz", {{"Host", host}}).result_int();
  };
  EXPECT_EQ(status("evil.example"), 421);
  EXPECT_EQ(status("viewer.example:80"), 200);
  EXPECT_EQ(status("192.168.1.5:80"), 200);
}

TEST_F(HttpTest, ARequestThatWasMeantForAnotherHostIsRefused) {
  for (const char* target : {"/", "/icon.svg", "/api/volumes", "/healthz", "/nowhere"}) {
    const auto answer = get(target, {{"Host", "evil.example:8080"}});
    EXPECT_EQ(answer.result_int(), 421) << target;
    EXPECT_NE(answer.body().find("allowed_origins"), std::string::npos) << answer.body();
  }
}

TEST_F(HttpTest, APageOfAStrangerOpensNoSessionByTakingOurAddress) {
  RawClient client(server.port());
  client.send(
      "GET /ws HTTP/1.1\r\nHost: evil.example\r\nOrigin: http://evil.example\r\n"
      "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
      "Sec-WebSocket-Protocol: cutaway.v1\r\n\r\n");
  EXPECT_TRUE(client.read_to_end().value().starts_with("HTTP/1.1 421 "));
}

TEST(Origin, IsOursOrListedOrAbsent) {
  const std::vector<std::string> listed = {"https://viewer.example"};
  EXPECT_TRUE(origin_allowed("", "127.0.0.1:8080", listed));
  EXPECT_TRUE(origin_allowed("http://127.0.0.1:8080", "127.0.0.1:8080", listed));
  EXPECT_TRUE(origin_allowed("https://Server.example", "server.example", listed));
  EXPECT_TRUE(origin_allowed("https://viewer.example", "127.0.0.1:8080", listed));
  EXPECT_FALSE(origin_allowed("http://127.0.0.1:8081", "127.0.0.1:8080", listed));
  EXPECT_FALSE(origin_allowed("http://evil.example", "127.0.0.1:8080", listed));
  EXPECT_FALSE(origin_allowed("null", "127.0.0.1:8080", listed));
  EXPECT_FALSE(origin_allowed("http://", "", listed));
}

}  // namespace
}  // namespace cutaway
