# SPDX-License-Identifier: GPL-3.0-or-later
# What the program needs on Linux, whose sources are those of the modules themselves.
find_package(TBB REQUIRED)
# Debian's CMake files of OpenImageIO ask for its programs and for OpenCV, which the library does not need.
find_path(OPENIMAGEIO_HEADERS OpenImageIO/imageio.h REQUIRED)
find_library(OPENIMAGEIO OpenImageIO REQUIRED)
find_library(OPENIMAGEIO_UTIL OpenImageIO_Util REQUIRED)
# CGAL's headers, and the libraries of exact numbers behind them.
find_path(CGAL_HEADERS CGAL/version.h REQUIRED)
find_library(GMP gmp REQUIRED)
find_library(MPFR mpfr REQUIRED)
# Debian's CMake files of Assimp name a static library of zlib that is not installed with it.
find_path(ASSIMP_HEADERS assimp/Importer.hpp REQUIRED)
find_library(ASSIMP assimp REQUIRED)
find_path(GLPK_HEADERS glpk.h REQUIRED)
find_library(GLPK glpk REQUIRED)
find_library(SECCOMP seccomp REQUIRED)
find_package(nlohmann_json REQUIRED)

# The program opens libraries by itself when it needs them.
set(CANDELABRA_LOADS ON)

function(link_for_system program)
  # It starts often and for small scenes, so the loader should have little to do: one search path, the same before and
  # after installation (CMake would fill one up with empty ones, which mean the current folder), and its own addresses in
  # few bytes.
  set_target_properties(${program} PROPERTIES BUILD_WITH_INSTALL_RPATH ON
                        INSTALL_RPATH "\$ORIGIN;\$ORIGIN/../${CMAKE_INSTALL_LIBDIR}/candelabra")
  target_link_options(${program} PRIVATE LINKER:-z,pack-relative-relocs)
endfunction()
