# How everything is compiled and where it lands in the build folder.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

get_property(LMS3D_IS_MULTI_CONFIG GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if (NOT LMS3D_IS_MULTI_CONFIG AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif ()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
list(PREPEND CMAKE_INSTALL_RPATH "$ORIGIN")

# Our own sources only: the generated wrappers are compiled with the compiler's defaults.
set(LMS3D_WARNINGS "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wshadow>")

# For ThreadSanitizer. The filters do without: they hand work over by TBB, whose library is not made for
# it, and would take a second for each scan.
set(LMS3D_CORBA_OPTIONS "" CACHE STRING
  "Further options for compiling and linking all that speaks CORBA, and its tests")
mark_as_advanced(LMS3D_CORBA_OPTIONS)
