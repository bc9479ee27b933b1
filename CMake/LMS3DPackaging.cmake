# find_package(LMS3D) for other projects, and the Debian package (cpack -G DEB).

include(CMakePackageConfigHelpers)

list(JOIN LMS3D_VTK_MODULES " " LMS3D_VTK_MODULE_NAMES)
set(lms3d_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/LMS3D")
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/LMS3DConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${lms3d_cmake_dir}/LMS3DConfig.cmake"
  INSTALL_DESTINATION "${lms3d_cmake_dir}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${lms3d_cmake_dir}/LMS3DConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${lms3d_cmake_dir}/LMS3DConfig.cmake"
    "${CMAKE_BINARY_DIR}/${lms3d_cmake_dir}/LMS3DConfigVersion.cmake"
  DESTINATION "${lms3d_cmake_dir}"
  COMPONENT development)
install(FILES LICENSE README.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The LMS3D developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if (LMS3D_BUILD_PARAVIEW_PLUGIN AND LMS3D_BUILD_PYTHON)
  # dpkg-shlibdeps finds shared libraries alone, and these two packages hold Python modules.
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-paraview, python3-numpy")
endif ()
include(CPack)
