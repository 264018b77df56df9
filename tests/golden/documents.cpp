#include "golden/documents.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace cutaway::test {

namespace {

namespace fs = std::filesystem;

Json read_json(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file.string() + " cannot be read");
  return Json::parse(stream);
}

fs::path folder() { return CUTAWAY_GOLDEN_FOLDER; }

std::vector<GoldenDocument> read_documents() {
  std::vector<GoldenDocument> documents;
  for (const auto& entry : fs::directory_iterator(folder() / "documents")) {
    if (entry.path().extension() != ".json") continue;
    fs::path picture = entry.path();
    documents.push_back({.name = entry.path().stem().string(),
                         .scene = read_json(entry.path()),
                         .picture = picture.replace_extension(".png")});
  }
  std::ranges::sort(documents, {}, &GoldenDocument::name);
  return documents;
}

void allow(std::vector<GoldenDocument>& documents, const std::string& name, const Json& exception) {
  const auto document = std::ranges::find(documents, name, &GoldenDocument::name);
  if (document == documents.end())
    throw std::runtime_error("exceptions.json: there is no document " + name);
  if (exception.at("reason").get<std::string>().empty())
    throw std::runtime_error("exceptions.json: no reason is given for " + name);
  document->allowed = {exception.at("mean").get<double>(),
                       exception.at("share_above_2").get<double>()};
}

}  // namespace

std::vector<GoldenDocument> golden_documents() {
  std::vector<GoldenDocument> documents = read_documents();
  const Json exceptions = read_json(folder() / "exceptions.json");
  for (const auto& [name, exception] : exceptions.items()) allow(documents, name, exception);
  return documents;
}

std::vector<OldOwnStyle> old_own_styles() {
  constexpr std::string_view kEnding = ".scene.json";
  std::vector<OldOwnStyle> styles;
  for (const auto& entry : fs::directory_iterator(folder() / "own_styles")) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with(kEnding)) continue;
    styles.push_back({file.substr(0, file.size() - kEnding.size()), read_json(entry.path())});
  }
  std::ranges::sort(styles, {}, &OldOwnStyle::name);
  return styles;
}

}  // namespace cutaway::test
