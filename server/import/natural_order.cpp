#include "import/natural_order.h"

#include <algorithm>
#include <compare>
#include <map>
#include <optional>

namespace cutaway::reading {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the run of digits, or of others, from the front of `text`.
std::string_view take_run(std::string_view& text) {
  std::size_t end = 1;
  while (end < text.size() && is_digit(text[end]) == is_digit(text[0])) ++end;
  const std::string_view run = text.substr(0, end);
  text.remove_prefix(end);
  return run;
}

std::string_view without_zeros(std::string_view digits) {
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string_view::npos ? std::string_view() : digits.substr(first);
}

std::strong_ordering compare_numbers(std::string_view a, std::string_view b) {
  const std::string_view short_a = without_zeros(a);
  const std::string_view short_b = without_zeros(b);
  if (const auto order = short_a.size() <=> short_b.size(); std::is_neq(order)) return order;
  return short_a <=> short_b;
}

struct Runs {
  std::vector<std::string> words;
  std::string pattern;  ///< digits as '#'
};

Runs runs_of(std::string_view name) {
  Runs runs;
  while (!name.empty()) {
    const std::string_view run = take_run(name);
    runs.words.emplace_back(run);
    runs.pattern += is_digit(run.front()) ? std::string("#") : std::string(run);
  }
  return runs;
}

/// The last run that is not the same in all names of one pattern.
std::optional<std::size_t> last_varying_run(const std::vector<Runs>& names) {
  for (std::size_t run = names.front().words.size(); run-- > 0;) {
    const bool varies = std::any_of(names.begin(), names.end(), [&](const Runs& name) {
      return name.words[run] != names.front().words[run];
    });
    if (varies) return run;
  }
  return std::nullopt;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += word;
  return text;
}

}  // namespace

bool NaturalOrder::operator()(std::string_view a, std::string_view b) const {
  const std::string_view whole_a = a;
  const std::string_view whole_b = b;
  while (!a.empty() && !b.empty()) {
    const std::string_view run_a = take_run(a);
    const std::string_view run_b = take_run(b);
    const bool numbers = is_digit(run_a.front()) && is_digit(run_b.front());
    const auto order = numbers ? compare_numbers(run_a, run_b) : run_a <=> run_b;
    if (std::is_neq(order)) return std::is_lt(order);
  }
  if (a.empty() != b.empty()) return a.empty();
  if (whole_a.size() != whole_b.size()) return whole_a.size() < whole_b.size();
  return whole_a < whole_b;
}

std::vector<std::vector<std::string>> stacks_of_names(std::vector<std::string> names) {
  std::sort(names.begin(), names.end(), NaturalOrder());
  std::map<std::string, std::vector<Runs>> by_pattern;
  for (const auto& name : names) {
    Runs runs = runs_of(name);
    by_pattern[runs.pattern].push_back(runs);
  }
  std::map<std::string, std::vector<std::string>, NaturalOrder> stacks;
  for (const auto& [pattern, members] : by_pattern) {
    const auto counter = last_varying_run(members);
    for (const Runs& member : members) {
      std::vector<std::string> key = member.words;
      if (counter) key[*counter] = "#";
      stacks[joined(key)].push_back(joined(member.words));
    }
  }
  std::vector<std::vector<std::string>> result;
  result.reserve(stacks.size());
  for (auto& [key, members] : stacks) result.push_back(std::move(members));
  return result;
}

}  // namespace cutaway::reading
