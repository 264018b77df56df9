#include "import/grids/voxel_data.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "import/grids/byte_stream.h"
#include "import/refusal.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kVoxelPieceBytes = std::size_t{1} << 20;

Compression compression_of(Encoding encoding) {
  if (encoding == Encoding::deflated) return Compression::deflate;
  if (encoding == Encoding::bzip2) return Compression::bzip2;
  return Compression::none;
}

std::uint64_t bytes_per_file(const VoxelData& data) {
  return data.count / data.files.size() * component_bytes(data.component);
}

/// The fewest bytes from the data's begin on in which a file can hold its share. An ASCII number
/// takes at least a digit, and a blank before the next.
double least_bytes_per_file(const VoxelData& data) {
  const auto skipped = static_cast<double>(data.skip_decoded);
  const auto bytes = static_cast<double>(bytes_per_file(data));
  switch (data.encoding) {
    case Encoding::raw:
      break;
    case Encoding::deflated:
    case Encoding::bzip2:
      return (skipped + bytes) / largest_ratio(compression_of(data.encoding));
    case Encoding::ascii:
      return skipped + 2 * bytes / static_cast<double>(component_bytes(data.component)) - 1;
    case Encoding::hex:
      return skipped + 2 * bytes;
  }
  return skipped + bytes;
}

std::uint64_t begin_of(const VoxelData& data, const fs::path& file) {
  return data.at_end_of_file ? fs::file_size(file) - bytes_per_file(data) : data.begin;
}

[[noreturn]] void refuse_short(const fs::path& file, std::uint64_t expected, std::uint64_t got) {
  refuse(file, "the file ends before its voxels do", bytes_in_words(static_cast<double>(expected)),
         bytes_in_words(static_cast<double>(got)));
}

/// What a share of the voxels goes through on its way from one file.
class Share {
 public:
  Share(const VoxelData& data, std::size_t file_index, const ReadContext& context)
      : data_(data),
        file_(data.files[file_index]),
        index_(static_cast<double>(file_index)),
        context_(context),
        stream_(file_, begin_of(data, file_), compression_of(data.encoding)) {
    if (!stream_.skip(data.skip_decoded)) refuse(file_, "the file ends before its voxels begin");
  }

  void read_binary(std::span<std::byte> output) {
    for (std::size_t done = 0; done < output.size();) {
      const auto piece = output.subspan(done, std::min(kVoxelPieceBytes, output.size() - done));
      const std::size_t got = stream_.read(piece);
      done += got;
      if (got < piece.size()) refuse_short(file_, output.size(), done);
      report();
    }
  }

  /// Goes on to the compressed stream's own checksum, at which broken data show; not for long where
  /// more follows.
  void check_end() {
    std::array<std::byte, 65536> beyond{};
    stream_.read(beyond);
  }

  void read_hex(std::span<std::byte> output) {
    for (std::byte& byte : output) {
      const int high = hex_digit();
      const int low = hex_digit();
      byte = static_cast<std::byte>(high * 16 + low);
    }
  }

  template <typename T>
  void read_ascii(std::span<T> output) {
    for (std::size_t i = 0; i < output.size(); ++i) {
      const std::string word = next_word();
      if (word.empty()) refuse_short(file_, output.size() * sizeof(T), i * sizeof(T));
      output[i] = parse<T>(word);
    }
  }

 private:
  void report() const {
    throw_if_cancelled(context_.stop);
    if (!context_.progress) return;
    const double fraction =
        (index_ + stream_.fraction_consumed()) / static_cast<double>(data_.files.size());
    context_.progress(LoadStage::read, fraction);
  }

  std::optional<char> next_character() {
    if (position_ == text_.size()) {
      text_.resize(kVoxelPieceBytes);
      text_.resize(stream_.read(std::as_writable_bytes(std::span(text_))));
      position_ = 0;
      report();
      if (text_.empty()) return std::nullopt;
    }
    return text_[position_++];
  }

  static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',';
  }

  std::string next_word() {
    constexpr std::size_t kLongestNumber = 512;
    std::string word;
    while (const auto c = next_character()) {
      if (is_blank(*c) && !word.empty()) break;
      if (!is_blank(*c)) word += *c;
      if (word.size() > kLongestNumber) refuse(file_, "the data hold what is no number");
    }
    return word;
  }

  int hex_digit() {
    while (const auto c = next_character()) {
      if (is_blank(*c)) continue;
      if (*c >= '0' && *c <= '9') return *c - '0';
      if (*c >= 'a' && *c <= 'f') return *c - 'a' + 10;
      if (*c >= 'A' && *c <= 'F') return *c - 'A' + 10;
      refuse(file_, "the data hold what is no hexadecimal digit");
    }
    refuse(file_, "the file ends before its voxels do");
  }

  template <typename T>
  T parse(const std::string& word) const {
    const auto value = real_of(word);
    const bool fits = value && (!std::is_integral_v<T> ||
                                (*value >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
                                 *value <= static_cast<double>(std::numeric_limits<T>::max())));
    if (!fits) refuse(file_, "the data hold a number that is not of their type", {}, word);
    return static_cast<T>(*value);
  }

  const VoxelData& data_;
  const fs::path& file_;
  double index_;
  const ReadContext& context_;
  ByteStream stream_;
  std::vector<char> text_;
  std::size_t position_ = 0;
};

void read_share(const VoxelData& data, Share& share, RawVoxels& voxels, std::uint64_t first,
                std::uint64_t count) {
  const std::size_t bytes = component_bytes(data.component);
  const auto output = bytes_of(voxels).subspan(first * bytes, count * bytes);
  if (data.encoding == Encoding::ascii) {
    std::visit([&](auto& values) { share.read_ascii(std::span(values).subspan(first, count)); },
               voxels);
  } else if (data.encoding == Encoding::hex) {
    share.read_hex(output);
  } else {
    share.read_binary(output);
    if (count == data.count / data.files.size()) share.check_end();
  }
}

void to_our_numbers(const VoxelData& data, RawVoxels& voxels) {
  if (data.encoding == Encoding::ascii) return;
  if (data.swapped) swap_byte_order(bytes_of(voxels), component_bytes(data.component));
  if (data.component == Component::int64 || data.component == Component::uint64) {
    convert_int64_in_place(std::get<std::vector<double>>(voxels), data.component);
  }
}

}  // namespace

bool is_swapped(bool file_is_big_endian) {
  return file_is_big_endian != (std::endian::native == std::endian::big);
}

void require_file_sizes(const VoxelData& data) {
  if (data.files.empty() || data.count % data.files.size() != 0) {
    refuse(data.files.empty() ? fs::path() : data.files.front(),
           "the voxels cannot be shared evenly among their files");
  }
  const double needed = std::ceil(least_bytes_per_file(data));
  for (const auto& file : data.files) {
    std::error_code failed;
    const auto size = static_cast<double>(fs::file_size(file, failed));
    if (failed) refuse(file, "the file cannot be read", {}, failed.message());
    const double available = size - (data.at_end_of_file ? 0.0 : static_cast<double>(data.begin));
    if (available >= needed) continue;
    refuse(file, "the file is shorter than its header says", "at least " + bytes_in_words(needed),
           bytes_in_words(std::max(0.0, available)));
  }
}

RawVoxels read_voxel_data(const VoxelData& data, std::uint64_t count, const ReadContext& context) {
  RawVoxels voxels = make_raw_voxels(data.component, count);
  const std::uint64_t per_file = data.count / data.files.size();
  for (std::size_t i = 0; i < data.files.size() && i * per_file < count; ++i) {
    throw_if_cancelled(context.stop);
    Share share(data, i, context);
    const std::uint64_t first = i * per_file;
    read_share(data, share, voxels, first, std::min(per_file, count - first));
  }
  to_our_numbers(data, voxels);
  return voxels;
}

}  // namespace cutaway::reading
