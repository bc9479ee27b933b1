# Debian 13 installs ParaView's Python modules as vtkX.cpython-*.so. ParaView's CMake files name them
# vtkX.so and stop with an error, so find_package(ParaView) fails. Here the build folder gets a copy of
# these CMake files with the right names, and ParaView_DIR names the copy. Other systems need no copy.

# Copies FOLDER/*.cmake to COPY. The files still compute their prefix from FOLDER.
function (lms3d_copy_paraview_package folder copy)
  file(REMOVE_RECURSE "${copy}")
  file(COPY "${folder}/" DESTINATION "${copy}")
  file(GLOB_RECURSE files RELATIVE "${copy}" "${copy}/*.cmake")
  foreach (file IN LISTS files)
    file(READ "${copy}/${file}" text)
    set(mended "${text}")
    get_filename_component(original "${folder}/${file}" DIRECTORY)
    string(REPLACE "_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\" PATH"
      "_IMPORT_PREFIX \"${folder}/${file}\" PATH" mended "${mended}")
    string(REPLACE "_import_prefix \"\${CMAKE_CURRENT_LIST_DIR}\""
      "_import_prefix \"${original}\"" mended "${mended}")
    string(REGEX REPLACE "(/dist-packages/[^\";]*)\\.so\"" "\\1${ARGN}\"" mended "${mended}")
    if (NOT mended STREQUAL text)
      file(WRITE "${copy}/${file}" "${mended}")
    endif ()
  endforeach ()
endfunction ()

file(GLOB lms3d_packages "/usr/lib/*/cmake/paraview-*/paraview-config.cmake")
set(lms3d_modules_folder "/usr/lib/python3/dist-packages/vtkmodules")
file(GLOB lms3d_module "${lms3d_modules_folder}/vtkCommonCore.cpython-*.so")
if (NOT ParaView_DIR AND lms3d_packages AND lms3d_module
    AND NOT EXISTS "${lms3d_modules_folder}/vtkCommonCore.so")
  list(GET lms3d_packages 0 lms3d_package)
  get_filename_component(lms3d_package "${lms3d_package}" DIRECTORY)
  get_filename_component(lms3d_suffix "${lms3d_module}" EXT)
  message(STATUS "Copying ParaView's CMake files: they misname Debian's Python modules")
  lms3d_copy_paraview_package("${lms3d_package}" "${CMAKE_BINARY_DIR}/paraview" "${lms3d_suffix}")
  set(ParaView_DIR "${CMAKE_BINARY_DIR}/paraview" CACHE PATH "ParaView's CMake files")
endif ()
