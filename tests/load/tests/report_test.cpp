#include <gtest/gtest.h>

#include <sstream>

#include "load/plot.h"
#include "load/report_html.h"
#include "load/report_json.h"
#include "load/report_table.h"

namespace cutaway::load {
namespace {

struct ReportTest : testing::Test {
  ReportTest() {
    script.title = "A <class>";
    script.roles = {{.name = "student"}};
    script.thresholds.latency_p95_ms = 10.0;
    RunOutcome outcome{.seconds = 10.0};
    Record record{.first_message_s = 0.0, .first_frame_s = 0.5, .moving = {{1.0, 9.0}}};
    for (int i = 0; i < 80; ++i)
      record.frames.push_back(
          {.at_s = 1.0 + 0.1 * i, .latency_ms = 30.0F, .bytes = 500, .moving = true});
    record.note_error("out-of-range: \"no\"");
    outcome.clients = {record};
    outcome.memory = {{1.0, 100.0}, {2.0, 101.0}};
    summary = summarise(script, outcome);
    checks = judge(script.thresholds, summary);
  }

  Script script;
  Summary summary;
  std::vector<Check> checks;
};

TEST_F(ReportTest, TableNamesWhatDidNotHold) {
  std::ostringstream out;
  print_table(out, script, summary, checks);
  EXPECT_NE(out.str().find("NOT HELD  latency p95"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("expected at most 10 ms, measured 30 ms"), std::string::npos);
  EXPECT_NE(out.str().find("out-of-range"), std::string::npos);
}

TEST_F(ReportTest, JsonHasTheFiguresAndNamesTheirUnits) {
  const auto report = json_report(script, summary, checks);
  EXPECT_EQ(report.at("held"), false);
  EXPECT_EQ(report.at("together").at("latency_ms").at("p95"), 30.0);
  EXPECT_EQ(report.at("clients").at(0).at("errors"), 1);
  EXPECT_EQ(report.at("memory").size(), 2U);
}

TEST_F(ReportTest, PageNeedsNothingFromElsewhere) {
  const std::string page = html_report(script, summary, checks);
  for (const char* word : {"<script", "http:", "https:", "url(", "<img", "<link"})
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  EXPECT_NE(page.find("A &lt;class&gt;"), std::string::npos);
  EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
  for (const char* plot :
       {"Latency from input", "Latency over time", "Frames per second", "Bytes a frame", "Memory"})
    EXPECT_NE(page.find(plot), std::string::npos) << plot;
  EXPECT_EQ(page.find("nan"), std::string::npos);
}

TEST(Plot, SaysWhenThereIsNothing) {
  EXPECT_NE(line_plot({"t", "x", "y"}, {{"n", "a", {}}}).find("Nothing was measured"),
            std::string::npos);
  EXPECT_NE(bar_plot({"t", "x", "y"}, {}).find("Nothing was measured"), std::string::npos);
  EXPECT_EQ(bar_plot({"t", "x", "y"}, {{"0", 0.0}}).find("nan"), std::string::npos);
}

}  // namespace
}  // namespace cutaway::load
