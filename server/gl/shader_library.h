// GLSL files with #include, whose errors name the file and line that a person wrote.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/embedded_file.h"

namespace cutaway::gl {

/// A shader with its includes put in. `#line` directives number the files; `file_names[number]` is
/// their name.
struct ExpandedShader {
  std::string text;
  std::vector<std::string> file_names;
};

/// Immutable once it is filled; then any thread.
class ShaderLibrary {
 public:
  /// They go by their names without folders, of which no two are alike.
  explicit ShaderLibrary(std::span<const EmbeddedFile> files);

  /// A file that is written at start-up, such as one made from a registry.
  void add(std::string name, std::string text) { files_[std::move(name)] = std::move(text); }

  /// The file with each `#include "name"` (or `#include NAME` of a definition) replaced, once per
  /// file, and `#define NAME VALUE` lines for `definitions` put after `#version`. Throws Error
  /// naming file and line for an unknown include.
  ExpandedShader expand(std::string_view name,
                        const std::map<std::string, std::string>& definitions = {}) const;

 private:
  std::map<std::string, std::string, std::less<>> files_;
};

/// A driver's compile log with its "0:12(3)" (Mesa) or "0(12)" (NVIDIA) prefixes turned into
/// "file.glsl:12".
std::string name_files_in_log(std::string_view log, const std::vector<std::string>& file_names);

}  // namespace cutaway::gl
