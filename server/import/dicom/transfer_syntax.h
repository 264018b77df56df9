// How the pixels of a file are packed, and what an object is that has none.
// Source: DICOM PS3.5, A; PS3.6, A.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cutaway::reading {

enum class PixelPacking { plain, rle, jpeg, jpeg_ls, jpeg_2000 };

/// For the words of a refusal: "HTJ2K", "JPEG baseline", or the UID where it is none of DICOM's.
std::string syntax_in_words(std::string_view uid);

/// Throws Error naming the file and the syntax where its pixels cannot be unpacked, or where the
/// syntax contradicts the way in which they lie in the file.
PixelPacking required_packing(const std::filesystem::path& file, std::string_view uid,
                              bool is_in_fragments);

/// Deflated, from the first element to the last.
bool is_unpacked_as_a_whole(std::string_view uid);

/// GE's own syntax, whose header is little and whose pixels are big-endian.
bool has_big_endian_pixels(std::string_view uid);

/// What a storage class holds besides images that make volumes: "a structured report (SR)";
/// "" for a class that is not known.
std::string_view object_in_words(std::string_view storage_class);

}  // namespace cutaway::reading
