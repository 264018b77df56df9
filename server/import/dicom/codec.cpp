#include "import/dicom/codec.h"

#include <fmt/format.h>
#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <mutex>

#include "import/data_root.h"
#include "import/dicom/codestream.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

/// GDCM prints to standard error; what matters of it comes back as a refusal.
void silence_gdcm() {
  static std::once_flag once;
  std::call_once(once, [] {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
  });
}

[[noreturn]] void refuse_broken(const PackedFrame& frame, const std::string& why) {
  refuse(frame.file, "the pixel data are broken or cut off", {},
         why + ", " + syntax_in_words(frame.transfer_syntax));
}

/// A picture of another size would be decoded into more memory than the header lets us expect.
StoredBits agreed_bits(const PackedFrame& frame) {
  if (frame.packing == PixelPacking::rle) return frame.bits;
  const auto found = codestream_of(frame.bytes, frame.packing);
  if (!found) refuse_broken(frame, "no picture in the compressed data");
  const bool same = found->columns == static_cast<std::uint32_t>(frame.columns) &&
                    found->rows == static_cast<std::uint32_t>(frame.rows) && found->samples == 1;
  if (!same) {
    refuse(frame.file, "the compressed picture is not what the header says",
           fmt::format("{}x{}, 1 sample", frame.columns, frame.rows),
           fmt::format("{}x{}, {} samples", found->columns, found->rows, found->samples));
  }
  const int allocated = found->bits <= 8 ? 8 : found->bits <= 16 ? 16 : 32;
  if (allocated == frame.bits.allocated) return frame.bits;
  return {allocated, found->bits, found->bits - 1, frame.bits.is_signed};
}

gdcm::Image image_of(const PackedFrame& frame, const StoredBits& bits) {
  gdcm::Image image;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned>(frame.columns));
  image.SetDimension(1, static_cast<unsigned>(frame.rows));
  image.SetPixelFormat(gdcm::PixelFormat(1, static_cast<unsigned short>(bits.allocated),
                                         static_cast<unsigned short>(bits.stored),
                                         static_cast<unsigned short>(bits.high_bit),
                                         static_cast<unsigned short>(bits.is_signed ? 1 : 0)));
  image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  image.SetTransferSyntax(gdcm::TransferSyntax::GetTSType(frame.transfer_syntax.c_str()));
  gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
  gdcm::Fragment fragment;
  fragment.SetByteValue(frame.bytes.data(), static_cast<std::uint32_t>(frame.bytes.size()));
  fragments->AddFragment(fragment);
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetVR(gdcm::VR::OB);
  pixels.SetValue(*fragments);
  image.SetDataElement(pixels);
  return image;
}

}  // namespace

PlainFrame unpacked(PackedFrame frame) {
  silence_gdcm();
  PlainFrame plain{.bytes = {}, .bits = agreed_bits(frame)};
  try {
    gdcm::Image image = image_of(frame, plain.bits);
    frame.bytes = {};
    const std::size_t needed = std::size_t(frame.columns) * frame.rows *
                               static_cast<std::size_t>(plain.bits.allocated / 8);
    plain.bytes.resize(image.GetBufferLength());
    if (plain.bytes.size() != needed || !image.GetBuffer(plain.bytes.data()))
      refuse_broken(frame, "its codec gave up");
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {  // GDCM's own, of streams, of memory
    refuse_broken(frame, printable(error.what()));
  }
  return plain;
}

}  // namespace cutaway::reading
