#include "load/schema_text.h"

#include "core/embedded_file.h"  // of the embedding itself; nothing else here is the server's

namespace cutaway {

std::span<const EmbeddedFile> load_script_schemas();

namespace load {

std::string_view script_schema_text() { return load_script_schemas().front().text; }

}  // namespace load
}  // namespace cutaway
