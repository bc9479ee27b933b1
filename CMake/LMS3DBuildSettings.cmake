# Compiler settings, and the folders of the build's output.

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

# Options for our own sources. Generated wrappers are compiled without them. Another compiler than GNU's
# and Clang gets none of them.
set(lms3d_gnu_like "$<CXX_COMPILER_ID:GNU,Clang,AppleClang>")
set(LMS3D_WARNINGS "$<${lms3d_gnu_like}:-Wall;-Wextra;-Wshadow>")

# Two sources that compute a number from the same operands must get the same bits. A compiler that
# contracts a*b+c into one instruction rounds differently from one source to the next.
set(LMS3D_FLOATING_POINT_OPTIONS "$<${lms3d_gnu_like}:-ffp-contract=off>")

# For loops that the compiler should vectorize: without errno, and without floating-point traps.
set(LMS3D_VECTOR_OPTIONS "$<${lms3d_gnu_like}:-fno-math-errno;-fno-trapping-math>")

# The kernels of the ray caster, and the instruction sets beyond the baseline of x86-64.
set(LMS3D_KERNEL_OPTIONS
  "$<${lms3d_gnu_like}:-O3>" "${LMS3D_FLOATING_POINT_OPTIONS}" "${LMS3D_VECTOR_OPTIONS}")
set(LMS3D_HAS_X86_KERNELS OFF)
if (CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$"
    AND CMAKE_CXX_COMPILER_ID MATCHES "^(GNU|Clang|AppleClang)$")
  set(LMS3D_HAS_X86_KERNELS ON)
  set(LMS3D_AVX2_OPTIONS -mavx2 -mfma)
  # Tuned for the first processors with these instructions: a scan of the room takes 2 % less.
  set(LMS3D_AVX512_OPTIONS -mavx512f -mavx512bw -mavx512dq -mavx512vl -mfma
    -mprefer-vector-width=512 -mtune=skylake-avx512)
endif ()

# For ThreadSanitizer. The filters are compiled without it: they share work through TBB, whose library is
# not built for ThreadSanitizer, and each scan would take a second.
set(LMS3D_CORBA_OPTIONS "" CACHE STRING
  "Further options to compile and link the CORBA server, its clients and their tests")
mark_as_advanced(LMS3D_CORBA_OPTIONS)
