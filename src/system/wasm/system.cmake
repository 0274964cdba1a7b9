# SPDX-License-Identifier: GPL-3.0-or-later
# What the program needs as WebAssembly, in node and in browsers. src/packaging/wasm/build.sh compiles the libraries.
include_directories(SYSTEM ${CANDELABRA_LIBRARIES}/include)  # GLM, Boost and other headers
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
add_library(TBB::tbb INTERFACE IMPORTED)  # one thread
set(OPENIMAGEIO "")
set(OPENIMAGEIO_UTIL "")
set(ASSIMP "")
set(GLPK "")
set(GMP "")
set(MPFR "")
set(SECCOMP "")
set(CANDELABRA_LOADS OFF)

# Code that rays and loops do not run is compiled for its size, which is most of a download.
set(cold text vocabulary syntax models png raster picture photometry font scene csg meshing reading appearance objects
         bind editor options console output session production preview tasks app relight web)

function(link_for_system program)
  foreach(module ${cold})
    target_compile_options(${module} PRIVATE -Os)
  endforeach()
  set(shell ${CMAKE_SOURCE_DIR}/src/system/wasm)
  set_target_properties(${program} PROPERTIES SUFFIX .mjs LINK_DEPENDS "${shell}/library.js")
  target_link_options(${program} PRIVATE
    -O2 -sMODULARIZE=1 -sEXPORT_ES6=1 -sEXPORT_NAME=candelabra -sENVIRONMENT=node,worker -sINVOKE_RUN=0 -sEXIT_RUNTIME=1
    -sEXPORTED_RUNTIME_METHODS=FS,callMain,ENV
    # The stack lies first, so that what grows beyond it traps. The memory grows in steps that the limit sees.
    -sSTACK_SIZE=64MB -sINITIAL_MEMORY=96MB -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB
    -sMEMORY_GROWTH_LINEAR_STEP=16MB -Wl,--stack-first -Wl,--wrap=emscripten_resize_heap
    --js-library ${shell}/library.js -lnodefs.js)
endfunction()
