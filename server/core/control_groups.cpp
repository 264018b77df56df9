#include "core/control_groups.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace cutaway {

namespace fs = std::filesystem;

namespace {

using Limit = std::optional<std::uint64_t>;

/// A group of one hierarchy: `mount` is where that is mounted, `path` lies in it.
struct Group {
  fs::path mount;
  fs::path path;
  bool is_version_1 = false;
};

Limit lesser(Limit a, Limit b) { return !a ? b : !b ? a : std::min(*a, *b); }

/// A file of one number; "max", which means none, is no number.
Limit number_in(const fs::path& file) {
  std::uint64_t number = 0;
  if (std::ifstream(file) >> number && number > 0) return number;
  return std::nullopt;
}

/// Of a group of version 1 and of all above it, those outside of a container's view, too.
Limit hierarchical_limit(const fs::path& statistics) {
  std::ifstream file(statistics);
  std::string name;
  std::uint64_t value = 0;
  while (file >> name >> value) {
    if (name == "hierarchical_memory_limit" && value > 0) return value;
  }
  return std::nullopt;
}

Limit limit_of(const fs::path& folder, bool is_version_1) {
  if (is_version_1) {
    return lesser(number_in(folder / "memory.limit_in_bytes"),
                  hierarchical_limit(folder / "memory.stat"));
  }
  return lesser(number_in(folder / "memory.max"), number_in(folder / "memory.high"));
}

Limit limit_up_from(const Group& group) {
  Limit least = limit_of(group.mount, group.is_version_1);
  fs::path folder = group.mount;
  for (const fs::path& part : group.path.lexically_normal().relative_path()) {
    // Above the mount, as a group moved out of a container's view is told: not to be seen from
    // here.
    if (part == "..") break;
    folder /= part;
    least = lesser(least, limit_of(folder, group.is_version_1));
  }
  return least;
}

bool names_memory(const std::string& controllers) {
  return ("," + controllers + ",").find(",memory,") != std::string::npos;
}

/// A line of /proc/self/cgroup: NUMBER:CONTROLLERS:PATH, without controllers for version 2.
std::optional<Group> group_of(const std::string& line, const fs::path& root) {
  const auto first = line.find(':');
  const auto second = line.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) return std::nullopt;
  const std::string controllers = line.substr(first + 1, second - first - 1);
  const fs::path mount = root / "sys/fs/cgroup";
  const fs::path path = line.substr(second + 1);
  if (controllers.empty()) return Group{mount, path, false};
  if (names_memory(controllers)) return Group{mount / "memory", path, true};
  return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> control_group_memory_bytes(const fs::path& root) {
  Limit least;
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    if (const auto group = group_of(line, root)) least = lesser(least, limit_up_from(*group));
  }
  return least;
}

}  // namespace cutaway
