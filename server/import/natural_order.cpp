#include "import/natural_order.h"

#include <algorithm>
#include <compare>
#include <map>
#include <optional>

#include "import/data_root.h"

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

/// What a number counts, by the letters before it.
enum class Counts { depth, anything, time, channel };

/// Of "img_channelZ" it is "z": names run together at a capital.
std::string last_word(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  std::size_t begin = text.size();
  while (begin > 0 && is_letter(text[begin - 1])) {
    --begin;
    const bool starts_word = begin > 0 && is_capital(text[begin]) && !is_capital(text[begin - 1]);
    if (starts_word) break;
  }
  return lower_case(text.substr(begin));
}

Counts counted_by(std::string_view before) {
  while (!before.empty() && std::string_view("_-=. ").find(before.back()) != std::string_view::npos)
    before.remove_suffix(1);
  const std::string word = last_word(before);
  const auto is_one_of = [&](auto... words) { return ((word == words) || ...); };
  if (is_one_of("z", "slice", "sl", "plane", "section", "depth", "layer")) return Counts::depth;
  if (is_one_of("c", "ch", "chan", "channel", "w", "wave", "wavelength", "lambda", "colour",
                "color"))
    return Counts::channel;
  if (is_one_of("t", "tp", "time", "timepoint", "frame")) return Counts::time;
  return Counts::anything;
}

/// The run that counts slices: the last of those that vary among the names of one pattern and are
/// called depth; else of those that are not called anything else.
std::optional<std::size_t> depth_run(const std::vector<Runs>& names) {
  std::optional<std::size_t> best;
  Counts best_counts = Counts::channel;
  const std::vector<std::string>& first = names.front().words;
  for (std::size_t run = first.size(); run-- > 0;) {
    const bool varies =
        std::ranges::any_of(names, [&](const Runs& name) { return name.words[run] != first[run]; });
    if (!varies) continue;
    const Counts counts = run > 0 ? counted_by(first[run - 1]) : Counts::anything;
    if (best && counts >= best_counts) continue;
    best = run;
    best_counts = counts;
  }
  return best;
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
    const auto counter = depth_run(members);
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
