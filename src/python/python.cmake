# SPDX-License-Identifier: GPL-3.0-or-later
# The module of Python. python/ of the build folder has it as it is installed, so that PYTHONPATH can name it.
set(package ${CMAKE_BINARY_DIR}/python/candelabra)
set(own ${CMAKE_CURRENT_LIST_DIR})
file(MAKE_DIRECTORY ${package})
Python3_add_library(candelabra_python MODULE WITH_SOABI ${own}/module.cpp)
target_link_libraries(candelabra_python PRIVATE tasks pybind11::headers)
# It waits for the modules, so it is compiled quickly. Only its entry point is visible.
target_compile_options(candelabra_python PRIVATE -O1 -fvisibility=hidden)
target_link_options(candelabra_python PRIVATE -Wl,--exclude-libs,ALL)
# Beside it lies what it opens itself in a wheel; a package has it where the program finds it.
set_target_properties(candelabra_python PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${package}
                      INSTALL_RPATH "\$ORIGIN;\$ORIGIN/../../../../${CMAKE_INSTALL_LIBDIR}/candelabra")
add_dependencies(candelabra_python ${CANDELABRA_LOADED})

# Python's own part, and the types of the options by their table.
set(sources ${own}/candelabra/__init__.py ${own}/candelabra/_core.pyi ${own}/candelabra/py.typed)
foreach(source ${sources})
  get_filename_component(name ${source} NAME)
  file(CREATE_LINK ${source} ${package}/${name} SYMBOLIC)
endforeach()
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/stdlib ${package}/stdlib SYMBOLIC)
set(types ${package}/_options.pyi)
add_custom_command(
  OUTPUT ${types}
  COMMAND ${Python3_EXECUTABLE} ${own}/option_types.py $<TARGET_FILE:candelabra> ${types}
  DEPENDS candelabra ${own}/option_types.py
  VERBATIM)
add_custom_target(python_package ALL DEPENDS ${types} candelabra_python)

set(CANDELABRA_PYTHON_FOLDER lib/python3/dist-packages CACHE STRING "Where the module of Python is installed")
install(TARGETS candelabra_python DESTINATION ${CANDELABRA_PYTHON_FOLDER}/candelabra COMPONENT python)
install(FILES ${sources} ${types} DESTINATION ${CANDELABRA_PYTHON_FOLDER}/candelabra COMPONENT python)
