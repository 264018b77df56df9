// How a DICOM file is strung together: enough to tell whether its end is missing.
#pragma once

#include <filesystem>

namespace cutaway::reading {

/// Throws Error naming the file where it ends within an element that lies before the pixels, as
/// interrupted copies do: GDCM ends the whole process there. Says nothing of a file without the
/// mark "DICM", of a deflated one, or from a place on that it does not understand: whatever GDCM
/// makes of that is right. Source: DICOM PS3.5, 7.1 and 7.5; PS3.10, 7.1.
void require_whole_elements(const std::filesystem::path& file);

}  // namespace cutaway::reading
