# OpenImageIO::OpenImageIO by pkg-config. Debian's CMake files for it want the programs of openimageio-tools, which
# nothing here runs, and name an include folder of a package that is not needed.
find_package(PkgConfig REQUIRED)
if(NOT TARGET OpenImageIO::OpenImageIO)
  pkg_check_modules(openimageio REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO>=2.4)
  add_library(OpenImageIO::OpenImageIO ALIAS PkgConfig::openimageio)
endif()
