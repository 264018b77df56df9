#include "import/dicom/transfer_syntax.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

struct Syntax {
  std::string_view uid;
  std::string_view name;
  std::optional<PixelPacking> packing = {};  ///< nothing where it is not read
};

constexpr std::string_view kDeflated = "1.2.840.10008.1.2.1.99";

constexpr std::array kSyntaxes{
    Syntax{"1.2.840.10008.1.2", "implicit VR, little endian", PixelPacking::plain},
    Syntax{"1.2.840.10008.1.2.1", "explicit VR, little endian", PixelPacking::plain},
    Syntax{"1.2.840.10008.1.2.2", "explicit VR, big endian", PixelPacking::plain},
    Syntax{kDeflated, "deflated", PixelPacking::plain},
    Syntax{"1.2.840.113619.5.2", "GE's own, big-endian pixels", PixelPacking::plain},
    Syntax{"1.2.840.10008.1.20", "Papyrus 3", PixelPacking::plain},
    Syntax{"1.2.840.10008.1.2.5", "RLE", PixelPacking::rle},
    Syntax{"1.2.840.10008.1.2.4.50", "JPEG baseline", PixelPacking::jpeg},
    Syntax{"1.2.840.10008.1.2.4.51", "JPEG extended", PixelPacking::jpeg},
    Syntax{"1.2.840.10008.1.2.4.52", "JPEG extended (3, 5)", PixelPacking::jpeg},
    Syntax{"1.2.840.10008.1.2.4.53", "JPEG spectral selection", PixelPacking::jpeg},
    Syntax{"1.2.840.10008.1.2.4.55", "JPEG progression", PixelPacking::jpeg},
    Syntax{"1.2.840.10008.1.2.4.57", "JPEG lossless", PixelPacking::jpeg},
    Syntax{"1.2.840.10008.1.2.4.70", "JPEG lossless, first order", PixelPacking::jpeg},
    Syntax{"1.2.840.10008.1.2.4.80", "JPEG-LS lossless", PixelPacking::jpeg_ls},
    Syntax{"1.2.840.10008.1.2.4.81", "JPEG-LS near-lossless", PixelPacking::jpeg_ls},
    Syntax{"1.2.840.10008.1.2.4.90", "JPEG 2000 lossless", PixelPacking::jpeg_2000},
    Syntax{"1.2.840.10008.1.2.4.91", "JPEG 2000", PixelPacking::jpeg_2000},
    Syntax{"1.2.840.10008.1.2.4.92", "JPEG 2000 part 2 lossless", PixelPacking::jpeg_2000},
    Syntax{"1.2.840.10008.1.2.4.93", "JPEG 2000 part 2", PixelPacking::jpeg_2000},
    Syntax{"1.2.840.10008.1.2.4.94", "JPIP, pixels on another server"},
    Syntax{"1.2.840.10008.1.2.4.95", "JPIP, pixels on another server, deflated"},
    Syntax{"1.2.840.10008.1.2.4.110", "JPEG XL lossless"},
    Syntax{"1.2.840.10008.1.2.4.111", "JPEG XL, recompressed JPEG"},
    Syntax{"1.2.840.10008.1.2.4.112", "JPEG XL"},
    Syntax{"1.2.840.10008.1.2.4.201", "High-Throughput JPEG 2000 (HTJ2K) lossless"},
    Syntax{"1.2.840.10008.1.2.4.202", "High-Throughput JPEG 2000 (HTJ2K) lossless, RPCL"},
    Syntax{"1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000 (HTJ2K)"},
    Syntax{"1.2.840.10008.1.2.4.204", "JPIP HTJ2K, pixels on another server"},
    Syntax{"1.2.840.10008.1.2.4.205", "JPIP HTJ2K, pixels on another server, deflated"},
    Syntax{"1.2.840.10008.1.2.8.1", "deflated image frames"}};

constexpr std::array kFamilies{Syntax{"1.2.840.10008.1.2.4.10", "MPEG video"},
                               Syntax{"1.2.840.10008.1.2.7.", "SMPTE ST 2110 video"}};

struct ObjectName {
  std::string_view uid;  ///< or the beginning of several
  std::string_view name;
};

constexpr std::array kObjects{
    ObjectName{"1.2.840.10008.1.3.10", "a DICOMDIR, which lists the files of a medium"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.66.4", "a segmentation (SEG)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.66.5", "a surface segmentation"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.66.7", "a label map segmentation (SEG)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.66.6", "a set of fibre tracts"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.66", "a registration or raw data"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.481.3", "a set of radiotherapy structures (RTSTRUCT)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.481.2", "a radiotherapy dose (RTDOSE)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.481.5", "a radiotherapy plan (RTPLAN)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.481", "a radiotherapy object"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.88.59", "a selection of key objects (KO)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.88", "a structured report (SR)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.11", "a presentation state (PR)"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.104", "an encapsulated document"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.9", "a waveform"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.4.2", "a set of MR spectra"},
    ObjectName{"1.2.840.10008.5.1.4.1.1.67", "a real world value mapping"}};

const Syntax* find_syntax(std::string_view uid) {
  const auto found = std::find_if(kSyntaxes.begin(), kSyntaxes.end(),
                                  [uid](const Syntax& s) { return s.uid == uid; });
  if (found != kSyntaxes.end()) return &*found;
  const auto family = std::find_if(kFamilies.begin(), kFamilies.end(),
                                   [uid](const Syntax& s) { return uid.starts_with(s.uid); });
  return family == kFamilies.end() ? nullptr : &*family;
}

}  // namespace

std::string syntax_in_words(std::string_view uid) {
  const Syntax* syntax = find_syntax(uid);
  return syntax ? std::string(syntax->name) + " (" + std::string(uid) + ")" : std::string(uid);
}

PixelPacking required_packing(const std::filesystem::path& file, std::string_view uid,
                              bool is_in_fragments) {
  if (uid.empty() && !is_in_fragments) return PixelPacking::plain;
  if (uid.empty()) refuse(file, "the file does not say how its pixels are compressed");
  const Syntax* syntax = find_syntax(uid);
  if (!syntax || !syntax->packing) {
    refuse(file, "the transfer syntax of the pixels is not read",
           "plain, deflated, RLE, JPEG, JPEG-LS or JPEG 2000", syntax_in_words(uid));
  }
  const bool is_plain = *syntax->packing == PixelPacking::plain;
  if (is_plain == is_in_fragments) {
    refuse(file, "the pixels do not lie in the file as its transfer syntax says",
           is_plain ? "one element" : "fragments", syntax_in_words(uid));
  }
  return *syntax->packing;
}

bool is_unpacked_as_a_whole(std::string_view uid) { return uid == kDeflated; }

bool has_big_endian_pixels(std::string_view uid) { return uid == "1.2.840.113619.5.2"; }

std::string_view object_in_words(std::string_view storage_class) {
  const auto found =
      std::find_if(kObjects.begin(), kObjects.end(), [storage_class](const ObjectName& object) {
        if (!storage_class.starts_with(object.uid)) return false;
        const std::string_view rest = storage_class.substr(object.uid.size());
        return rest.empty() || rest.front() == '.';
      });
  return found == kObjects.end() ? std::string_view() : found->name;
}

}  // namespace cutaway::reading
