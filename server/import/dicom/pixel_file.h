// The pixels of one file, frame by frame.
#pragma once

#include <string>
#include <vector>

#include "import/dicom/codec.h"
#include "import/dicom/data_set.h"
#include "import/dicom/frame.h"

namespace cutaway::reading {

/// Holds no pixels: each frame is read, and decoded where it is packed, by itself.
class PixelFile {
 public:
  /// Throws Error naming the file where it has no pixels that fit `image`.
  explicit PixelFile(std::shared_ptr<const DicomImage> image);

  /// As they lie in the file: the same for two frames of one syntax whose pixels are the same.
  std::string packed(int frame);
  PlainFrame plain(int frame);

  /// Neither this frame nor what lies before it in the file is asked for again.
  void forget(int frame);

  /// Of how long the frame is and of the bytes in its middle: cheap, and different for most frames
  /// of one syntax that differ.
  std::string glimpse(int frame);

 private:
  struct Place {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
  };

  std::uint64_t frame_bytes() const;
  Place place_of(int frame) const;
  void read_bits(const DataSet& data);
  void find_fragments();
  Place next_fragment(std::uint64_t& offset);
  void share_out(const std::vector<std::uint64_t>& offsets);
  void share_out_by_offsets(const std::vector<std::uint64_t>& offsets);
  void share_out_by_pictures();

  std::shared_ptr<const DicomImage> image_;
  ByteSource source_;
  DicomHeader header_;
  PixelPacking packing_ = PixelPacking::plain;
  StoredBits bits_;
  bool is_big_endian_ = false;
  std::vector<Place> fragments_;
  std::vector<std::size_t> first_fragment_;  ///< of each frame, and one more
};

}  // namespace cutaway::reading
