// Where things lie on this machine is not a client's to know.
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"

namespace cutaway {

/// `path` from the data folder `root` on; its last part where it lies elsewhere.
std::string path_for_client(const std::filesystem::path& path, const std::filesystem::path& root);

/// `text` with every path below `root` written from there on.
std::string text_for_client(std::string text, const std::filesystem::path& root);

/// `error` about the volume `id` as the client who asked for it gets it: its field points into the
/// scene, and what names the volume is its id.
Error error_for_client(const Error& error, const std::string& id);

}  // namespace cutaway
