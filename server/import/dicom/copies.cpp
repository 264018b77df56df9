#include "import/dicom/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "core/progress.h"
#include "import/dicom/pixel_file.h"

namespace cutaway::reading {

namespace {

constexpr double kSamePositionMm = 1e-3;

/// Compares pixels, and keeps the two files open that it was asked of last: planes of one file come
/// in a row.
class PixelComparison {
 public:
  explicit PixelComparison(const std::vector<DicomFrame>& frames) : frames_(frames) {}

  bool are_same(std::size_t a, std::size_t b) {
    const DicomFrame& frame_a = frames_[a];
    const DicomFrame& frame_b = frames_[b];
    const bool same_syntax = frame_a.image->transfer_syntax == frame_b.image->transfer_syntax;
    if (same_syntax && (glimpse(a).empty() || glimpse(a) != glimpse(b))) return false;
    try {
      PixelFile& file_a = opened(slots_[0], frame_a);
      PixelFile& file_b = frame_a.image == frame_b.image ? file_a : opened(slots_[1], frame_b);
      if (same_syntax) return file_a.packed(frame_a.index) == file_b.packed(frame_b.index);
      return file_a.plain(frame_a.index).bytes == file_b.plain(frame_b.index).bytes;
    } catch (const Error&) {
      return false;
    }
  }

 private:
  struct Slot {
    std::shared_ptr<const DicomImage> image;
    std::optional<PixelFile> file;
  };

  static PixelFile& opened(Slot& slot, const DicomFrame& frame) {
    if (slot.image == frame.image) return *slot.file;
    slot.image.reset();
    slot.file.emplace(frame.image);
    slot.image = frame.image;
    return *slot.file;
  }

  /// "" where the pixels cannot be read.
  const std::string& glimpse(std::size_t i) {
    auto& glimpse = glimpses_[i];
    if (glimpse) return *glimpse;
    try {
      PixelFile& file = opened(slots_[0], frames_[i]);
      glimpse = file.glimpse(frames_[i].index);
    } catch (const Error&) {
      glimpse = "";
    }
    return *glimpse;
  }

  const std::vector<DicomFrame>& frames_;
  std::map<std::size_t, std::optional<std::string>> glimpses_;
  std::array<Slot, 2> slots_;
};

bool have_same_values(const DicomFrame& a, const DicomFrame& b) {
  return a.image->component == b.image->component && a.meaning == b.meaning &&
         a.image->low_is_bright == b.image->low_is_bright;
}

bool say_the_same(const DicomFrame& a, const DicomFrame& b) {
  std::array keys_a = a.keys;
  std::array keys_b = b.keys;
  keys_a[static_cast<std::size_t>(PlaneKey::content_time)].clear();  // exporters write their own
  keys_b[static_cast<std::size_t>(PlaneKey::content_time)].clear();
  constexpr auto kInstance = static_cast<std::size_t>(Moment::instance);
  return keys_a == keys_b && a.moments.at(kInstance) == b.moments.at(kInstance);
}

/// Which of the planes at one place are copies of one before them.
class Copies {
 public:
  Copies(const std::vector<DicomFrame>& frames, const std::stop_token& stop)
      : frames_(frames),
        places_(places_of(frames)),
        plain_copy_(frames.size()),
        copy_(frames.size()),
        pixels_(frames) {
    for (std::size_t i = 1; i < frames.size(); ++i) {
      throw_if_cancelled(stop);
      for (std::size_t j = i; j-- > 0 && places_[j] == places_[i] && !plain_copy_[i];)
        if (!plain_copy_[j]) compare(i, j);
    }
  }

  /// Also of other times where no place keeps two planes then.
  const std::vector<bool>& to_leave_out() const {
    const auto copies = static_cast<std::size_t>(std::count(copy_.begin(), copy_.end(), true));
    return frames_.size() - copies == places_.back() + 1 ? copy_ : plain_copy_;
  }

 private:
  void compare(std::size_t i, std::size_t j) {
    const bool coincide =
        glm::length(frames_[i].position_mm - frames_[j].position_mm) < kSamePositionMm;
    if (!coincide || !have_same_values(frames_[i], frames_[j])) return;
    if (!pixels_.are_same(i, j)) return;
    copy_[i] = true;
    if (say_the_same(frames_[i], frames_[j])) plain_copy_[i] = true;
  }

  const std::vector<DicomFrame>& frames_;
  std::vector<std::size_t> places_;
  std::vector<bool> plain_copy_;
  std::vector<bool> copy_;
  PixelComparison pixels_;
};

std::string warning_of(const std::vector<DicomFrame>& left_out) {
  const std::string first = left_out.front().image->file.filename().string();
  if (left_out.size() == 1) return fmt::format("1 slice is a copy of another; left out: {}", first);
  return fmt::format("{} slices are copies of others; left out: {} and {} more", left_out.size(),
                     first, left_out.size() - 1);
}

}  // namespace

void leave_out_copies(DicomGroup& group, const std::stop_token& stop) {
  const std::vector<bool> is_copy = Copies(group.frames, stop).to_leave_out();
  std::vector<DicomFrame> kept;
  std::vector<DicomFrame> left_out;
  for (std::size_t i = 0; i < group.frames.size(); ++i)
    (is_copy[i] ? left_out : kept).push_back(std::move(group.frames[i]));
  group.frames = std::move(kept);
  if (!left_out.empty()) group.warnings.push_back(warning_of(left_out));
}

}  // namespace cutaway::reading
