// Changes of headers that keep their form: another number in the place of one, in text or in binary
// fields; a line or an element again or gone. A byte changed anywhere mostly makes a header that is
// refused at its first glance.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Generator = std::minstd_rand;
using Bytes = std::string;

std::size_t below(Generator& generator, std::size_t limit) { return generator() % limit; }

constexpr const char* kNumbers[] = {
    "0",          "-1",         "1",     "2",      "3",
    "7",          "64",         "100",   "255",    "256",
    "65535",      "65536",      "1e3",   "-2.5",   "2147483647",
    "2147483648", "1e-9",       "1e300", "-1e38",  "nan",
    "inf",        "4294967296", "1e-40", "0.0001", "18446744073709551616"};

struct Run {
  std::size_t begin = 0;
  std::size_t length = 0;
};

/// Of digits with what belongs to them.
std::vector<Run> numbers_in(const Bytes& text) {
  const auto belongs = [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!belongs(text[i])) continue;
    const std::size_t begin = i;
    while (i < text.size() && belongs(text[i])) ++i;
    runs.push_back({begin, i - begin});
  }
  return runs;
}

void change_number(Bytes& text, Generator& generator) {
  const std::vector<Run> runs = numbers_in(text);
  if (runs.empty()) return;
  const Run run = runs[below(generator, runs.size())];
  text.replace(run.begin, run.length, kNumbers[below(generator, std::size(kNumbers))]);
}

void change_line(Bytes& text, Generator& generator) {
  const std::size_t begin = text.rfind('\n', below(generator, text.size())) + 1;  // from 0 for none
  const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
  if (end <= begin) return;
  const Bytes line = text.substr(begin, end - begin);
  if (below(generator, 2) == 0) {
    text.erase(begin, line.size());
  } else {
    text.insert(begin, line);
  }
}

template <typename Number>
void put(Bytes& bytes, std::size_t at, Number number) {
  if (at + sizeof(number) <= bytes.size()) std::memcpy(bytes.data() + at, &number, sizeof(number));
}

void change_field(Bytes& bytes, Generator& generator) {
  const std::size_t at = 2 * below(generator, bytes.size() / 2 + 1);
  static constexpr std::int64_t kIntegers[] = {
      0, -1, 1, 2, 3, 4, 8, 64, 348, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF, 1000, 40000};
  static constexpr double kReals[] = {0.0, -1.0, 0.5, 100.0, 1e-9, 1e9, 1e300, 1e-320, -1e38};
  const std::int64_t integer = kIntegers[below(generator, std::size(kIntegers))];
  const double real = kReals[below(generator, std::size(kReals))];
  switch (below(generator, 5)) {
    case 0:
      return put(bytes, at, static_cast<std::int16_t>(integer));
    case 1:
      return put(bytes, at, static_cast<std::int32_t>(integer));
    case 2:
      return put(bytes, at, integer);
    case 3:
      return put(bytes, at, static_cast<float>(std::clamp(real, -3e38, 3e38)));
    default:
      return put(bytes, at, real);
  }
}

/// Elements and entries have even lengths, mostly of 8 and more.
void double_piece(Bytes& bytes, Generator& generator) {
  const std::size_t begin = 2 * below(generator, bytes.size() / 2 + 1);
  const std::size_t length = std::min(2 * (1 + below(generator, 16)), bytes.size() - begin);
  bytes.insert(begin, bytes.substr(begin, length));
}

bool is_text(const Bytes& bytes) {
  const auto end =
      bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size(), 8));
  return std::all_of(bytes.begin(), end, [](char c) { return c >= ' ' || c == '\n' || c == '\r'; });
}

Bytes mutated(Bytes bytes, Generator& generator) {
  const bool first = below(generator, 4) != 0;
  if (is_text(bytes)) {
    first ? change_number(bytes, generator) : change_line(bytes, generator);
  } else {
    first ? change_field(bytes, generator) : double_piece(bytes, generator);
  }
  return bytes;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  Generator generator(seed + 1);
  if (size == 0 || below(generator, 2) == 0) return LLVMFuzzerMutate(data, size, most);
  const Bytes changed = mutated({reinterpret_cast<const char*>(data), size}, generator);
  if (changed.empty() || changed.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}
