#[[
Finds omniORB 4, a CORBA ORB for C++, through pkg-config: omniORB has no CMake files of its own.

Targets: omniORB4::omniORB4
         omniORB4::SSL, the transport for TLS, which has no pkg-config file
Variable: omniORB4_OMNIIDL, the IDL compiler that belongs to the library
Function: omniorb4_add_idl_library(TARGET FILE.idl...), a static library of stubs and skeletons

No target is global: a project that adds LMS3D as a subdirectory does not see them.
]]

find_package(PkgConfig QUIET)
if (PkgConfig_FOUND)
  pkg_check_modules(omniORB4_PKG QUIET IMPORTED_TARGET omniORB4)
  pkg_get_variable(omniidl omniORB4 omniidl)
  if (EXISTS "${omniidl}")
    # Not an omniidl from PATH: stubs of another version do not compile against this library.
    set(omniORB4_OMNIIDL "${omniidl}")
  endif ()
endif ()
find_library(omniORB4_SSL_LIBRARY omnisslTP4 HINTS ${omniORB4_PKG_LIBRARY_DIRS})
mark_as_advanced(omniORB4_SSL_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(omniORB4
  REQUIRED_VARS omniORB4_PKG_LIBRARIES omniORB4_OMNIIDL omniORB4_SSL_LIBRARY
  VERSION_VAR omniORB4_PKG_VERSION)

if (omniORB4_FOUND AND NOT TARGET omniORB4::omniORB4)
  add_library(omniORB4::omniORB4 ALIAS PkgConfig::omniORB4_PKG)
  add_library(omniORB4::SSL UNKNOWN IMPORTED)
  set_target_properties(omniORB4::SSL PROPERTIES
    IMPORTED_LOCATION "${omniORB4_SSL_LIBRARY}"
    INTERFACE_LINK_LIBRARIES omniORB4::omniORB4)
endif ()

# Relative file names start at the current source folder. The files may include one another.
function (omniorb4_add_idl_library target)
  set(generated)
  set(dependencies)
  foreach (file IN LISTS ARGN)
    get_filename_component(path "${file}" ABSOLUTE)
    list(APPEND dependencies "${path}")
  endforeach ()
  foreach (file IN LISTS dependencies)
    get_filename_component(name "${file}" NAME_WE)
    set(outputs "${CMAKE_CURRENT_BINARY_DIR}/${name}.hh" "${CMAKE_CURRENT_BINARY_DIR}/${name}SK.cc")
    add_custom_command(
      OUTPUT ${outputs}
      COMMAND "${omniORB4_OMNIIDL}" -bcxx -Wbuse-quotes "-C${CMAKE_CURRENT_BINARY_DIR}" "${file}"
      DEPENDS ${dependencies}
      COMMENT "omniidl ${name}.idl"
      VERBATIM)
    list(APPEND generated ${outputs})
  endforeach ()
  add_library(${target} STATIC ${generated})
  # A ParaView plugin links the library, too, and hides the stubs.
  set_target_properties(${target} PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${target} SYSTEM PUBLIC "${CMAKE_CURRENT_BINARY_DIR}")
  target_link_libraries(${target} PUBLIC omniORB4::omniORB4)
endfunction ()
