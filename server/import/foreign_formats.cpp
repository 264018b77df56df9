#include "import/foreign_formats.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "import/data_root.h"

namespace cutaway::reading {

namespace {

struct ByEnding {
  std::string_view ending;
  const char* what;
};

struct ByMark {
  std::size_t offset;
  std::string_view bytes;
  const char* what;
};

constexpr const char* kMinc = "a MINC volume";
constexpr const char* kAfni = "an AFNI dataset";
constexpr const char* kVtk = "VTK data";
constexpr const char* kHdf5 = "HDF5 data";
constexpr const char* kNumpy = "a NumPy array";
constexpr const char* kMrc = "an MRC or CCP4 map";
constexpr const char* kMicroscope = "a microscope's own format";
constexpr const char* kMesh = "a surface mesh, not a volume";

constexpr std::array kEndings{ByEnding{".mgz", "a FreeSurfer volume (MGH)"},
                              ByEnding{".mgh", "a FreeSurfer volume (MGH)"},
                              ByEnding{".mnc", kMinc},
                              ByEnding{".mnc.gz", kMinc},
                              ByEnding{".head", kAfni},
                              ByEnding{".brik", kAfni},
                              ByEnding{".brik.gz", kAfni},
                              ByEnding{".vtk", kVtk},
                              ByEnding{".vti", kVtk},
                              ByEnding{".vtp", kVtk},
                              ByEnding{".vtu", kVtk},
                              ByEnding{".vtr", kVtk},
                              ByEnding{".par", "a Philips PAR/REC scan"},
                              ByEnding{".mif", "an MRtrix volume"},
                              ByEnding{".mif.gz", "an MRtrix volume"},
                              ByEnding{".mih", "an MRtrix volume"},
                              ByEnding{".h5", kHdf5},
                              ByEnding{".hdf5", kHdf5},
                              ByEnding{".npy", kNumpy},
                              ByEnding{".npz", kNumpy},
                              ByEnding{".mrc", kMrc},
                              ByEnding{".ccp4", kMrc},
                              ByEnding{".czi", kMicroscope},
                              ByEnding{".lsm", kMicroscope},
                              ByEnding{".nd2", kMicroscope},
                              ByEnding{".lif", kMicroscope},
                              ByEnding{".oib", kMicroscope},
                              ByEnding{".oif", kMicroscope},
                              ByEnding{".ims", kMicroscope},
                              ByEnding{".stk", kMicroscope},
                              ByEnding{".vsi", kMicroscope},
                              ByEnding{".svs", kMicroscope},
                              ByEnding{".ndpi", kMicroscope},
                              ByEnding{".isq", "a Scanco scan"},
                              ByEnding{".aim", "a Scanco scan"},
                              ByEnding{".vol", "raw voxels without a header that is read"},
                              ByEnding{".pic", "a Bio-Rad stack"},
                              ByEnding{".am", "an Amira mesh"},
                              ByEnding{".stl", kMesh},
                              ByEnding{".ply", kMesh}};

constexpr std::array kMarks{ByMark{0, "# vtk DataFile", kVtk},
                            ByMark{0, "<VTKFile", kVtk},
                            ByMark{0, "\x89HDF\r\n\x1a\n", kHdf5},
                            ByMark{0, "CDF\x01", kMinc},
                            ByMark{0, "CDF\x02", kMinc},
                            ByMark{0, "\x93NUMPY", kNumpy},
                            ByMark{208, "MAP ", kMrc},
                            ByMark{0, "ZISRAWFILE", kMicroscope},
                            ByMark{0, "\xDA\xCE\xBE\x0A", kMicroscope},
                            ByMark{0, "# AmiraMesh", "an Amira mesh"},
                            ByMark{0, "mrtrix image", "an MRtrix volume"},
                            ByMark{0, "# === DATA DESCRIPTION FILE", "a Philips PAR/REC scan"}};

std::string first_bytes(const std::filesystem::path& file) {
  std::string bytes(256, '\0');
  std::ifstream input(file, std::ios::binary);
  input.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(input.gcount()));
  return bytes;
}

}  // namespace

std::optional<std::string> foreign_format_of(const std::filesystem::path& file) {
  const std::string name = lower_case(file.filename().string());
  for (const auto& [ending, what] : kEndings) {
    if (name.ends_with(ending)) return what;
  }
  const std::string bytes = first_bytes(file);
  for (const auto& [offset, mark, what] : kMarks) {
    if (bytes.size() > offset && std::string_view(bytes).substr(offset).starts_with(mark))
      return what;
  }
  return std::nullopt;
}

}  // namespace cutaway::reading
