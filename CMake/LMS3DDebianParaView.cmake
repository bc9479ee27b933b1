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

# Sets ParaView_DIR to a new copy if the Debian system at ROOT, empty for this system, needs one. Every
# configuration replaces the copy. The build configures again if apt installs another version.
function (lms3d_mend_debian_paraview root)
  set(copy "${CMAKE_BINARY_DIR}/paraview")
  if (ParaView_DIR STREQUAL copy)
    unset(ParaView_DIR CACHE)
    file(REMOVE_RECURSE "${copy}")
  endif ()
  file(GLOB packages "${root}/usr/lib/*/cmake/paraview-*/paraview-config.cmake")
  set(modules "${root}/usr/lib/python3/dist-packages/vtkmodules")
  file(GLOB module "${modules}/vtkCommonCore.cpython-*.so")
  if (ParaView_DIR OR NOT packages OR NOT module OR EXISTS "${modules}/vtkCommonCore.so")
    return ()
  endif ()
  list(GET packages 0 package)
  get_filename_component(folder "${package}" DIRECTORY)
  get_filename_component(suffix "${module}" EXT)
  message(STATUS "Copying ParaView's CMake files: they misname Debian's Python modules")
  lms3d_copy_paraview_package("${folder}" "${copy}" "${suffix}")
  set(ParaView_DIR "${copy}" CACHE PATH "ParaView's CMake files" FORCE)

  # dpkg writes these lists when it installs. The packages' own files have the time of their release.
  foreach (name IN ITEMS paraview-dev python3-paraview)
    set(list "${root}/var/lib/dpkg/info/${name}.list")
    if (EXISTS "${list}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${list}")
    endif ()
  endforeach ()
endfunction ()
