#include "import/isolation/voxel_transfer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "core/error.h"
#include "core/released_pages.h"

namespace cutaway::reading {

namespace {

constexpr std::size_t kPieceBytes = std::size_t{16} << 20;

[[noreturn]] void refuse(const char* message) {
  throw Error({.code = ErrorCode::volume_refused, .message = message});
}

void read_piece(const Descriptor& file, std::size_t begin, std::span<std::byte> piece) {
  for (std::size_t done = 0; done < piece.size();) {
    const ssize_t got = pread(file.get(), piece.data() + done, piece.size() - done,
                              static_cast<off_t>(begin + done));
    if (got <= 0) refuse("its reader's voxels cannot be taken over");
    done += static_cast<std::size_t>(got);
  }
}

/// Where that cannot be, the memory comes back with the file's end.
void empty_piece(const Descriptor& file, std::size_t begin, std::size_t bytes) {
  fallocate(file.get(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(begin),
            static_cast<off_t>(bytes));
}

}  // namespace

void write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written <= 0) throw std::runtime_error("the answer cannot be written");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

template <typename T>
void hand_over(std::vector<T> voxels, int descriptor) {
  std::span<std::byte> rest = std::as_writable_bytes(std::span(voxels));
  while (!rest.empty()) {
    const auto piece = rest.first(std::min(kPieceBytes, rest.size()));
    write_all(descriptor, piece);
    release_pages(piece);
    rest = rest.subspan(piece.size());
  }
}

template <typename T>
std::vector<T> take_over(const Descriptor& file, std::size_t count) {
  struct stat status {};
  const std::size_t bytes = count * sizeof(T);
  if (fstat(file.get(), &status) != 0 || static_cast<std::size_t>(status.st_size) != bytes)
    refuse("its reader delivered another number of voxels");
  std::vector<T> voxels;
  voxels.reserve(count);
  while (voxels.size() < count) {
    const std::size_t begin = voxels.size();
    voxels.resize(std::min(begin + kPieceBytes / sizeof(T), count));
    const auto piece = std::as_writable_bytes(std::span(voxels).subspan(begin));
    read_piece(file, begin * sizeof(T), piece);
    empty_piece(file, begin * sizeof(T), piece.size());
  }
  return voxels;
}

template void hand_over(std::vector<std::uint16_t>, int);
template void hand_over(std::vector<float>, int);
template std::vector<std::uint16_t> take_over(const Descriptor&, std::size_t);
template std::vector<float> take_over(const Descriptor&, std::size_t);

}  // namespace cutaway::reading
