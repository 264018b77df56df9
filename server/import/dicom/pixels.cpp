#include "import/dicom/pixels.h"

#include <fmt/format.h>
#include <gdcmImageReader.h>

#include <cstring>
#include <limits>
#include <type_traits>

#include "import/data_root.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

Component component_of(const std::filesystem::path& file, const gdcm::PixelFormat& format) {
  const bool is_signed = format.GetPixelRepresentation() == 1;
  switch (format.GetBitsAllocated()) {
    case 8:
      return is_signed ? Component::int8 : Component::uint8;
    case 16:
      return is_signed ? Component::int16 : Component::uint16;
    case 32:
      return is_signed ? Component::int32 : Component::uint32;
    default:
      break;
  }
  refuse(file, "this pixel size is not read", "8, 16 or 32 bits",
         fmt::format("{} bits", format.GetBitsAllocated()));
}

/// Only the stored bits count: others may hold overlays, or nothing that was meant.
template <typename T>
T stored_value(const char* bytes, int bits_stored, int high_bit) {
  using Unsigned = std::make_unsigned_t<T>;
  constexpr int kBits = std::numeric_limits<Unsigned>::digits;
  Unsigned raw = 0;
  std::memcpy(&raw, bytes, sizeof(raw));
  const auto at_top = static_cast<Unsigned>(raw << (kBits - 1 - high_bit));
  return static_cast<T>(static_cast<T>(at_top) >> (kBits - bits_stored));
}

/// How stored values lie in the decoded bytes.
struct StoredBits {
  int stored = 16;
  int high_bit = 15;
};

template <typename From, typename To>
void convert(const char* bytes, StoredBits bits, const DicomFrame& frame, std::size_t first,
             std::span<To> output, PaddingMask& padding) {
  for (std::size_t i = 0; i < output.size(); ++i) {
    const From value = stored_value<From>(bytes + i * sizeof(From), bits.stored, bits.high_bit);
    if (frame.padding && frame.padding->contains(static_cast<double>(value)))
      padding[first + i] = 1;
    if constexpr (std::is_integral_v<To>) {
      output[i] = static_cast<To>(value);  // NOLINT(bugprone-signed-char-misuse): numbers, no text
    } else {
      output[i] = static_cast<To>(static_cast<double>(value) * frame.slope + frame.intercept);
    }
  }
}

gdcm::Image read_image(const std::filesystem::path& file) {
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) {
    const auto syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
    const char* name = gdcm::TransferSyntax::GetTSString(syntax);
    refuse(file, "the pixel data are broken or cut off", {},
           fmt::format("transfer syntax {}", name ? name : "unknown"));
  }
  return reader.GetImage();
}

void require_same(const DicomFrame& frame, std::size_t frames, const gdcm::Image& image) {
  const std::size_t decoded_frames = image.GetNumberOfDimensions() > 2 ? image.GetDimension(2) : 1;
  const bool same = image.GetColumns() == static_cast<unsigned>(frame.size_px.x) &&
                    image.GetRows() == static_cast<unsigned>(frame.size_px.y) &&
                    decoded_frames == frames && image.GetPixelFormat().GetSamplesPerPixel() == 1;
  if (same) return;
  refuse(frame.file, "the pixel data are not what the header says",
         fmt::format("{}x{}, {} frames", frame.size_px.x, frame.size_px.y, frames),
         fmt::format("{}x{}, {} frames", image.GetColumns(), image.GetRows(), decoded_frames));
}

}  // namespace

DicomPixels::DicomPixels(const DicomFrame& any_frame_of_file, std::size_t frames_in_file)
    : file_(any_frame_of_file.file) {
  try {
    const gdcm::Image image = read_image(file_);
    require_same(any_frame_of_file, frames_in_file, image);
    const gdcm::PixelFormat& format = image.GetPixelFormat();
    component_ = component_of(file_, format);
    bits_stored_ = format.GetBitsStored();
    high_bit_ = format.GetHighBit();
    frame_voxels_ = std::size_t(any_frame_of_file.size_px.x) * any_frame_of_file.size_px.y;
    bytes_.resize(image.GetBufferLength());
    const std::size_t needed = frame_voxels_ * frames_in_file * component_bytes(component_);
    if (bytes_.size() < needed || !image.GetBuffer(bytes_.data())) {
      refuse(file_, "the pixel data are broken or cut off",
             bytes_in_words(static_cast<double>(needed)));
    }
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {  // GDCM's own, of streams, of memory
    refuse(file_, "the pixel data are broken", {}, printable(error.what()));
  }
  const int bits = static_cast<int>(component_bytes(component_)) * 8;
  if (bits_stored_ < 1 || bits_stored_ > bits || high_bit_ >= bits ||
      high_bit_ + 1 < bits_stored_) {
    refuse(file_, "the pixels' bits are not usable", fmt::format("at most {} bits", bits),
           fmt::format("{} bits stored, high bit {}", bits_stored_, high_bit_));
  }
}

void DicomPixels::store(const DicomFrame& frame, std::size_t first, RawVoxels& voxels,
                        PaddingMask& padding) const {
  const char* bytes =
      bytes_.data() + std::size_t(frame.index) * frame_voxels_ * component_bytes(component_);
  const StoredBits bits{bits_stored_, high_bit_};
  std::visit(
      [&](auto& values) {
        const std::span output = std::span(values).subspan(first, frame_voxels_);
        switch (component_) {
          case Component::int8:
            return convert<std::int8_t>(bytes, bits, frame, first, output, padding);
          case Component::uint8:
            return convert<std::uint8_t>(bytes, bits, frame, first, output, padding);
          case Component::int16:
            return convert<std::int16_t>(bytes, bits, frame, first, output, padding);
          case Component::uint16:
            return convert<std::uint16_t>(bytes, bits, frame, first, output, padding);
          case Component::int32:
            return convert<std::int32_t>(bytes, bits, frame, first, output, padding);
          default:
            return convert<std::uint32_t>(bytes, bits, frame, first, output, padding);
        }
      },
      voxels);
}

}  // namespace cutaway::reading
