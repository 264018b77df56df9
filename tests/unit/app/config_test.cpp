// The configuration file: what is read, and what is refused with file and line.
#include "app/config.h"

#include <gtest/gtest.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <fstream>

#include "app/config_keys.h"
#include "core/error.h"

namespace cutaway {
namespace {

namespace fs = std::filesystem;

class ConfigTest : public ::testing::Test {
 protected:
  ~ConfigTest() override { fs::remove(file); }

  void read(const std::string& text) {
    std::ofstream(file) << text;
    read_config_file(file, config);
  }
  Error::Detail refused(const std::string& text) {
    try {
      read(text);
    } catch (const Error& error) {
      return error.detail();
    }
    ADD_FAILURE() << "this was accepted: " << text;
    return {};
  }
  std::string line(int number) const { return file.string() + ":" + std::to_string(number); }

  fs::path file =
      fs::temp_directory_path() / ("cutaway-config-" + std::to_string(getpid()) + ".toml");
  Config config;
};

TEST_F(ConfigTest, HasDefaultsThatWork) {
  EXPECT_EQ(config.net.address, "127.0.0.1");
  EXPECT_EQ(config.net.port, 8080);
  EXPECT_EQ(config.net.message_bytes, 65536);
  EXPECT_EQ(config.session.frames_in_flight, 2);
  EXPECT_EQ(config.session.viewport_side_px, 4096);
}

TEST_F(ConfigTest, ReadsEveryKind) {
  read(R"(
[server]
listen = "[::1]:9000"
sessions = 3
idle_timeout_ms = 5000
allowed_origins = ["https://viewer.example"]
web_root = "site"
[session]
frame_budget_ms = 16.5
rest_ms = 300
[volumes]
data = ["ct", "/data/mr"]
memory_bytes = 2000000000
[renderer]
require_gpu = true
[log]
level = "debug"
)");
  EXPECT_EQ(config.net.address, "::1");
  EXPECT_EQ(config.net.port, 9000);
  EXPECT_EQ(config.net.sessions, 3);
  EXPECT_EQ(config.net.idle_timeout, std::chrono::milliseconds(5000));
  EXPECT_EQ(config.net.allowed_origins, std::vector<std::string>{"https://viewer.example"});
  EXPECT_EQ(config.net.web_root, file.parent_path() / "site");
  EXPECT_EQ(config.session.frame_budget.count(), 16.5);
  EXPECT_EQ(config.session.rest.count(), 300.0);
  EXPECT_EQ(config.volumes.data, (std::vector<fs::path>{file.parent_path() / "ct", "/data/mr"}));
  EXPECT_EQ(config.volumes.memory_bytes, 2'000'000'000);
  EXPECT_TRUE(config.renderer.require_gpu);
  EXPECT_EQ(config.log_level, "debug");
}

TEST_F(ConfigTest, AnEmptyFileChangesNothing) {
  read("");
  EXPECT_EQ(config.net.port, 8080);
}

TEST_F(ConfigTest, RefusesAnUnknownKeyNamingLineAndThoseThatAreKnown) {
  const Error::Detail detail = refused("[session]\nrest_ms = 100\nrest_sm = 200\n");
  EXPECT_EQ(detail.field, line(3));
  EXPECT_NE(detail.message.find("rest_sm"), std::string::npos);
  EXPECT_NE(detail.expected.find("rest_ms"), std::string::npos);
}

TEST_F(ConfigTest, RefusesAnUnknownTable) {
  const Error::Detail detail = refused("\n[sessoin]\nrest_ms = 100\n");
  EXPECT_EQ(detail.field, line(2));
  EXPECT_NE(detail.expected.find("[session]"), std::string::npos);
}

TEST_F(ConfigTest, RefusesAKeyOutsideOfATable) { EXPECT_EQ(refused("port = 80\n").field, line(1)); }

TEST_F(ConfigTest, RefusesAWrongType) {
  const Error::Detail detail = refused("[server]\nsessions = \"many\"\n");
  EXPECT_EQ(detail.field, line(2));
  EXPECT_EQ(detail.expected, "an integer");
  EXPECT_NE(detail.received.find("many"), std::string::npos);
  EXPECT_EQ(refused("[volumes]\ndata = \"folder\"\n").expected, "a list of texts");
  EXPECT_EQ(refused("[volumes]\ndata = [1]\n").expected, "a text");
  EXPECT_EQ(refused("[renderer]\nrequire_gpu = 1\n").expected, "true or false");
  EXPECT_EQ(refused("[server]\nsessions = 1.5\n").expected, "an integer");
}

TEST_F(ConfigTest, RefusesAValueOutOfRangeNamingTheRange) {
  const Error::Detail detail = refused("[session]\n\nframes_in_flight = 0\n");
  EXPECT_EQ(detail.field, line(3));
  EXPECT_EQ(detail.expected, "1 to 8");
  EXPECT_EQ(detail.received, "0");
  EXPECT_NE(detail.message.find("session.frames_in_flight"), std::string::npos);
  EXPECT_EQ(refused("[session]\nrest_ms = nan\n").code, ErrorCode::out_of_range);
  EXPECT_EQ(refused("[session]\nrest_ms = -1\n").code, ErrorCode::out_of_range);
  EXPECT_EQ(refused("[log]\nlevel = \"loud\"\n").field, line(2));
  EXPECT_EQ(refused("[server]\nlisten = \"8080\"\n").field, line(2));
}

TEST_F(ConfigTest, RefusesWhatIsNotToml) {
  EXPECT_EQ(refused("[server]\nsessions = = 3\n").field, line(2));
}

TEST_F(ConfigTest, RefusesAFileThatIsNotThere) {
  EXPECT_THROW(read_config_file("/nowhere/cutaway.toml", config), Error);
}

TEST_F(ConfigTest, TheDocumentedFileHasEveryKeyAtItsDefault) {
  const fs::path documented = CUTAWAY_SOURCE_DIR "/deploy/cutaway.toml";
  read_config_file(documented, config);
  EXPECT_EQ(config, Config());
  const toml::table tables = toml::parse_file(documented.string());
  for (const ConfigKey& key : config_keys()) {
    EXPECT_TRUE(tables[key.table][key.name]) << key.table << "." << key.name << " is left out";
  }
}

// So a file that says another default is not equal: no key is left out of the comparison.
TEST_F(ConfigTest, EveryKeyChangesTheConfiguration) {
  const toml::table tables = toml::parse_file(CUTAWAY_SOURCE_DIR "/deploy/cutaway.toml");
  for (const ConfigKey& key : config_keys()) {
    const auto* kind = std::get_if<IntegerKey>(&key.kind);
    if (kind == nullptr) continue;
    const auto documented = tables[key.table][key.name].value<std::int64_t>();
    ASSERT_TRUE(documented) << key.name;
    Config other;
    kind->set(other, *documented == kind->minimum ? kind->maximum : kind->minimum);
    EXPECT_NE(other, Config()) << key.name;
  }
}

TEST_F(ConfigTest, EveryIntegerKeyTakesItsLimitsAndNothingBeyond) {
  for (const ConfigKey& key : config_keys()) {
    const auto* kind = std::get_if<IntegerKey>(&key.kind);
    if (kind == nullptr) continue;
    const std::string head = "[" + std::string(key.table) + "]\n" + std::string(key.name) + " = ";
    read(head + std::to_string(kind->minimum));
    read(head + std::to_string(kind->maximum));
    EXPECT_EQ(refused(head + std::to_string(kind->minimum - 1)).code, ErrorCode::out_of_range)
        << key.name;
    EXPECT_EQ(refused(head + std::to_string(kind->maximum + 1)).code, ErrorCode::out_of_range)
        << key.name;
  }
}

TEST_F(ConfigTest, HostsAndProxiesAreWhatTheySay) {
  read(R"([server]
hosts = ["viewer.example", "[fd00::1]"]
trusted_proxies = ["10.0.0.0/8", "127.0.0.1", "fd00::/8"]
)");
  EXPECT_EQ(config.net.hosts, (std::vector<std::string>{"viewer.example", "[fd00::1]"}));
  EXPECT_EQ(config.net.trusted_proxies.size(), 3);
  for (const std::string bad :
       {"hosts = ['https://viewer.example']", "hosts = ['viewer.example:80']", "hosts = ['']",
        "trusted_proxies = ['proxy.example']", "trusted_proxies = ['10.0.0.0/33']"}) {
    EXPECT_EQ(refused("[server]\n" + bad).field, line(2)) << bad;
  }
}

TEST(Listen, TakesAddressAndPort) {
  NetSettings settings;
  parse_listen("0.0.0.0:0", settings);
  EXPECT_EQ(settings.address, "0.0.0.0");
  EXPECT_EQ(settings.port, 0);
  for (const char* bad : {"", "8080", ":8080", "127.0.0.1", "127.0.0.1:", "127.0.0.1:70000",
                          "127.0.0.1:80x", "127.0.0.1:-1"}) {
    EXPECT_THROW(parse_listen(bad, settings), Error) << bad;
  }
}

}  // namespace
}  // namespace cutaway
