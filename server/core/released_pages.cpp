#include "core/released_pages.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace cutaway {

void release_pages(std::span<std::byte> memory) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto address = reinterpret_cast<std::uintptr_t>(memory.data());
  const std::uintptr_t skipped = (page - address % page) % page;
  if (memory.size() < skipped + page) return;
  const std::size_t bytes = (memory.size() - skipped) / page * page;
  madvise(memory.data() + skipped, bytes, MADV_DONTNEED);
}

}  // namespace cutaway
