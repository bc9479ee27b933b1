# The VTK modules. Each source is compiled once; Python and ParaView only wrap the result.

set(module_files
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/Readers/vtk.module")
if (LMS3D_BUILD_CORBA)
  list(APPEND module_files "${CMAKE_CURRENT_SOURCE_DIR}/Plugins/CORBA/Remote/vtk.module")
endif ()
vtk_module_scan(
  MODULE_FILES ${module_files}
  PROVIDES_MODULES lms3d_modules
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)

# What the modules and the CORBA adapter share.
add_subdirectory(Filters/Geometry)
add_subdirectory(Filters/Device)

# The library version has two parts because vtk_module_build ignores a SOVERSION of "0".
vtk_module_build(
  MODULES ${lms3d_modules}
  PACKAGE LMS3D
  INSTALL_EXPORT LMS3D
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/lms3d"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/LMS3D"
  TEST_DIRECTORY_NAME NONE)

vtk_module_export_find_packages(
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/LMS3D"
  FILE_NAME LMS3D-vtk-module-find-packages.cmake
  MODULES ${lms3d_modules})
