// An executable that answers as the hidden subcommand of `cutaway` does, and ways for it to go
// wrong.
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "import/isolation/import_worker.h"

namespace {

void say(std::string_view line) {
  const std::string text = std::string(line) + "\n";
  if (write(3, text.data(), text.size()) < 0) std::exit(9);
}

/// A sanitizer would catch the signal and end the process in its own way.
void crash() {
  signal(SIGSEGV, SIG_DFL);
  raise(SIGSEGV);
}

constexpr std::string_view kHead =
    R"({"volume":{"description":{"id":"x","title":"x","format":"NIfTI","modality":"","units":"none","warnings":[]},)"
    R"("geometry":{"size":[2,2,SIZE],"spacing":[1,1,1],"origin":[0,0,0],"axes":[[1,0,0],[0,1,0],[0,0,1]]},)"
    R"("float":FLOAT,"scale":1,"offset":0,"range":[0,1]}})";

/// More than any limit of the tests allows, but not so much that it fills the machine where none is
/// kept.
bool write_without_end() {
  const std::vector<char> piece(std::size_t{1} << 20, 'x');
  for (int i = 0; i < 256; ++i) {
    if (write(4, piece.data(), piece.size()) < 0) return false;
  }
  return true;
}

std::string head(const char* size, const char* is_float) {
  std::string text(kHead);
  text.replace(text.find("SIZE"), 4, size);
  text.replace(text.find("FLOAT"), 5, is_float);
  return text;
}

/// Passes on what the real worker says, and crashes where that names a file "crash..." for the
/// second time: the first is only to say that the walk came by.
int relay(const char* log) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return 9;
  if (fork() == 0) {
    dup2(ends[1], 3);
    close(ends[0]);
    close(ends[1]);
    _exit(cutaway::run_import_worker());  // threads of libraries have not come along to be ended
  }
  close(ends[1]);
  std::ofstream log_file(log, std::ios::app);
  std::ifstream reports("/proc/self/fd/" + std::to_string(ends[0]));
  std::set<std::string> named;
  for (std::string line; std::getline(reports, line);) {
    log_file << line << std::endl;
    say(line);
    const bool is_crasher = line.starts_with(R"({"file")") && line.find("/crash") != line.npos;
    if (is_crasher && !named.insert(line).second) crash();
  }
  return 0;
}

int misbehave(std::string_view mode) {
  if (mode == "crash") crash();
  if (mode == "crash-at-file") {
    say(R"({"file":"/crasher.nii"})");
    crash();
  }
  if (mode == "crash-at-grouping") {
    say(R"({"file":"/innocent.dcm"})");
    say(R"({"grouping":true})");
    crash();
  }
  if (mode == "progress-then-hang") {
    say(R"({"progress":["read",0.5]})");
    while (true) pause();
  }
  if (mode == "answer-then-linger") {
    say(head("2", "false"));
    close(3);
    while (true) pause();
  }
  if (mode == "spin") {
    volatile bool endless = true;
    while (endless) {
    }
  }
  if (mode == "hog") {
    std::vector<std::string> hoard;
    hoard.reserve(64);
    for (int i = 0; i < 64; ++i) hoard.emplace_back(std::size_t{256} << 20, 'x');
  }
  if (mode == "garbage") say("this is no JSON");
  if (mode == "null-range") say(R"({"volume":{"range":[null,1]}})");
  if (mode == "huge-grid") say(head("32768", "false"));
  if (mode == "too-few-voxels") {
    say(head("2", "false"));
    if (write(4, "1234", 4) != 4) return 9;
  }
  if (mode == "nan-voxels") {
    say(head("2", "true"));
    const std::vector<unsigned char> bytes(32, 0xFF);
    if (write(4, bytes.data(), bytes.size()) != 32) return 9;
  }
  if (mode == "write-without-end") {
    say(head("2", "false"));
    return write_without_end() ? 0 : 9;
  }
  if (mode == "exit-7") return 7;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "";
  if (mode == "read-volume-worker") return cutaway::run_import_worker();
  if (mode == "crash-at-names" && argc > 2) return relay(argv[2]);
  return misbehave(mode);
}
