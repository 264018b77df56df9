#include "load/verdict.h"

#include <algorithm>

#include "load/figures.h"

namespace cutaway::load {

namespace {

class Judge {
 public:
  void at_most(const char* name, std::optional<double> limit, std::optional<double> measured,
               const char* unit) {
    if (limit)
      add(name, "at most " + figure(*limit, unit), measured, unit, measured && *measured <= *limit);
  }
  void at_least(const char* name, std::optional<double> limit, std::optional<double> measured,
                const char* unit) {
    if (limit)
      add(name, "at least " + figure(*limit, unit), measured, unit,
          measured && *measured >= *limit);
  }
  std::vector<Check> checks() && { return std::move(checks_); }

 private:
  void add(const char* name, std::string expected, std::optional<double> measured, const char* unit,
           bool held) {
    checks_.push_back(
        {name, std::move(expected), measured ? figure(*measured, unit) : "nothing", held});
  }

  std::vector<Check> checks_;
};

std::optional<double> if_any(const Distribution& from, double figure) {
  if (from.count == 0) return std::nullopt;
  return figure;
}

}  // namespace

std::vector<Check> judge(const Thresholds& thresholds, const Summary& all) {
  const auto count = [](auto number) { return static_cast<double>(number); };
  Judge judge;
  judge.at_most("clients without a frame", 0.0, count(all.without_frame), "");
  judge.at_most("disconnects", count(thresholds.disconnects), count(all.disconnects), "");
  judge.at_most("errors", count(thresholds.errors), count(all.errors), "");
  judge.at_most("stale frames", count(thresholds.stale_frames), count(all.stale_frames), "");
  judge.at_most("latency p95", thresholds.latency_p95_ms,
                if_any(all.latency_ms, all.latency_ms.p95), "ms");
  judge.at_most("latency growth", thresholds.latency_growth_ms, all.latency_growth_ms, "ms");
  judge.at_least("frames per second", thresholds.frames_per_second, all.least_frames_per_second,
                 "/s");
  judge.at_most("time to first frame", thresholds.first_frame_s,
                if_any(all.first_frame_s, all.first_frame_s.max), "s");
  judge.at_most("time to still p95", thresholds.still_s, if_any(all.still_s, all.still_s.p95), "s");
  judge.at_most("fairness", thresholds.fairness, all.fairness, "");
  if (!all.memory.empty())  // it was watched
    judge.at_most("memory growth", thresholds.memory_growth_mib, all.memory_growth_mib, "MiB");
  return std::move(judge).checks();
}

bool all_held(const std::vector<Check>& checks) {
  return std::ranges::all_of(checks, &Check::held);
}

}  // namespace cutaway::load
