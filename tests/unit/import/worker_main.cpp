// An executable that answers as the hidden subcommand of `cutaway` does, and ways for it to go
// wrong.
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "import/import_worker.h"

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

std::string head(const char* size, const char* is_float) {
  std::string text(kHead);
  text.replace(text.find("SIZE"), 4, size);
  text.replace(text.find("FLOAT"), 5, is_float);
  return text;
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
  if (mode == "exit-7") return 7;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "";
  return mode == "read-volume-worker" ? cutaway::run_import_worker() : misbehave(mode);
}
