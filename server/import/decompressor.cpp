#include "import/decompressor.h"

#include <bzlib.h>
#include <zlib.h>

#include <limits>
#include <utility>

#include "core/check.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_broken(const fs::path& file, const char* why = nullptr) {
  refuse(file, "the compressed data are broken", {}, why ? why : "");
}

/// Both libraries count the bytes left at either end, and never write to their input.
template <typename Stream, typename Call>
int run(Stream& stream, std::span<const std::byte>& input, std::span<std::byte>& output,
        Call call) {
  using Byte = std::remove_const_t<std::remove_pointer_t<decltype(stream.next_out)>>;
  stream.next_in = reinterpret_cast<Byte*>(const_cast<std::byte*>(input.data()));
  stream.avail_in = static_cast<unsigned>(input.size());
  stream.next_out = reinterpret_cast<Byte*>(output.data());
  stream.avail_out = static_cast<unsigned>(output.size());
  const int result = call(stream);
  input = input.last(stream.avail_in);
  output = output.last(stream.avail_out);
  return result;
}

class Inflater final : public Decompressor {
 public:
  explicit Inflater(fs::path file) : file_(std::move(file)) {
    constexpr int kZlibOrGzip = 15 + 32;
    if (inflateInit2(&stream_, kZlibOrGzip) != Z_OK) refuse(file_, "zlib cannot be set up");
  }
  ~Inflater() override { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  bool step(std::span<const std::byte>& input, std::span<std::byte>& output) override {
    const int result =
        run(stream_, input, output, [](z_stream& stream) { return inflate(&stream, Z_NO_FLUSH); });
    if (result == Z_STREAM_END) return inflateReset(&stream_) == Z_OK;
    if (result != Z_OK && result != Z_BUF_ERROR) refuse_broken(file_, stream_.msg);
    return false;
  }

  bool may_begin_with(std::byte first) const override { return first == std::byte{0x1F}; }

 private:
  fs::path file_;
  z_stream stream_{};
};

class Bunzipper final : public Decompressor {
 public:
  explicit Bunzipper(fs::path file) : file_(std::move(file)) { begin(); }
  ~Bunzipper() override { BZ2_bzDecompressEnd(&stream_); }
  Bunzipper(const Bunzipper&) = delete;
  Bunzipper& operator=(const Bunzipper&) = delete;

  bool step(std::span<const std::byte>& input, std::span<std::byte>& output) override {
    const int result =
        run(stream_, input, output, [](bz_stream& stream) { return BZ2_bzDecompress(&stream); });
    if (result != BZ_OK && result != BZ_STREAM_END) refuse_broken(file_);
    if (result == BZ_STREAM_END) {
      BZ2_bzDecompressEnd(&stream_);
      begin();
    }
    return result == BZ_STREAM_END;
  }

  bool may_begin_with(std::byte first) const override { return first == std::byte{'B'}; }

 private:
  void begin() {
    stream_ = {};
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) refuse(file_, "bzip2 cannot be set up");
  }

  fs::path file_;
  bz_stream stream_{};
};

}  // namespace

double largest_ratio(Compression compression) {
  switch (compression) {
    case Compression::none:
      break;
    case Compression::deflate:
      return 1032.0;
    case Compression::bzip2:
      return 900'000.0 * 259 / 5 / 33;
  }
  return 1.0;
}

std::unique_ptr<Decompressor> make_decompressor(const fs::path& file, Compression compression) {
  check(compression != Compression::none, "there is something to decompress");
  if (compression == Compression::bzip2) return std::make_unique<Bunzipper>(file);
  return std::make_unique<Inflater>(file);
}

}  // namespace cutaway::reading
