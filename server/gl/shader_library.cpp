#include "gl/shader_library.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include "core/check.h"
#include "core/error.h"

namespace cutaway::gl {

namespace {

using Files = std::map<std::string, std::string, std::less<>>;

/// Walks one shader and its includes; each file is put in at its first include only.
class Expansion {
 public:
  Expansion(const Files& files, const std::map<std::string, std::string>& definitions)
      : files_(files), definitions_(definitions) {}

  ExpandedShader run(std::string_view name) {
    append_file(name, "the program");
    return {std::move(text_), std::move(names_)};
  }

 private:
  void append_file(std::string_view name, const std::string& included_from) {
    if (std::ranges::find(names_, name) != names_.end()) return;
    const auto found = files_.find(name);
    if (found == files_.end()) {
      throw Error({.code = ErrorCode::internal,
                   .message = "unknown shader file",
                   .field = included_from,
                   .expected = "the name of an embedded shader",
                   .received = std::string(name)});
    }
    const auto number = names_.size();
    names_.emplace_back(name);
    if (number > 0) mark_line(1, number);
    append_lines(found->second, number);
  }

  void append_lines(const std::string& content, std::size_t number) {
    static const std::regex include(R"(^\s*#include\s+(\S+)\s*$)");
    std::istringstream lines(content);
    std::string line;
    for (int at = 1; std::getline(lines, line); ++at) {
      std::smatch match;
      if (std::regex_match(line, match, include)) {
        append_file(included_name(match[1]), names_[number] + ":" + std::to_string(at));
        mark_line(at + 1, number);
      } else {
        text_ += line + "\n";
        if (line.starts_with("#version")) append_definitions(at + 1, number);
      }
    }
  }

  /// `"file"`, or a definition whose value is that.
  std::string included_name(const std::string& written) const {
    const auto defined = definitions_.find(written);
    const std::string& quoted = defined == definitions_.end() ? written : defined->second;
    return quoted.size() > 2 && quoted.front() == '"' ? quoted.substr(1, quoted.size() - 2)
                                                      : quoted;
  }

  void append_definitions(int next_line, std::size_t number) {
    for (const auto& [name, value] : definitions_)
      text_.append("#define ").append(name).append(" ").append(value).append("\n");
    mark_line(next_line, number);
  }

  void mark_line(int line, std::size_t number) {
    text_ += "#line " + std::to_string(line) + " " + std::to_string(number) + "\n";
  }

  const Files& files_;
  const std::map<std::string, std::string>& definitions_;
  std::string text_;
  std::vector<std::string> names_;
};

}  // namespace

ShaderLibrary::ShaderLibrary(std::span<const EmbeddedFile> files) {
  for (const EmbeddedFile& file : files) {
    const std::string_view name = file.name.substr(file.name.rfind('/') + 1);
    check(files_.emplace(name, file.text).second,
          "two shader files are called " + std::string(name));
  }
}

ExpandedShader ShaderLibrary::expand(std::string_view name,
                                     const std::map<std::string, std::string>& definitions) const {
  return Expansion(files_, definitions).run(name);
}

std::string name_files_in_log(std::string_view log, const std::vector<std::string>& file_names) {
  static const std::regex position(R"(^(\d+)[:(](\d+)\)?)");
  std::istringstream lines{std::string(log)};
  std::string line;
  std::string named;
  while (std::getline(lines, line)) {
    std::smatch match;
    if (std::regex_search(line, match, position) && std::stoul(match[1]) < file_names.size()) {
      line = file_names[std::stoul(match[1])] + ":" + match[2].str() + match.suffix().str();
    }
    named += line + "\n";
  }
  return named;
}

}  // namespace cutaway::gl
