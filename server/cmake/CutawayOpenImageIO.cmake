# OpenImageIO::OpenImageIO as Debian packages it.
find_package(OpenImageIO 2.4 REQUIRED)

# The package names an include folder that belongs to a package it does not need.
get_target_property(image_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach(folder IN LISTS image_includes)
  if(NOT EXISTS ${folder})
    list(REMOVE_ITEM image_includes ${folder})
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${image_includes}")
