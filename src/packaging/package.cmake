# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed for desktops, editors and packagers; `cpack` in the build folder makes a .deb, and a tarball that
# runs from wherever it is unpacked.
set(own ${CMAKE_CURRENT_LIST_DIR})
set(CANDELABRA_PICTURES_URL "" CACHE STRING "Where the web has examples/pictures/, for the screenshots of AppStream")

# The sources that a package is made of.
set(metainfo ${CMAKE_BINARY_DIR}/candelabra.metainfo.xml)
add_custom_command(
  OUTPUT ${metainfo}
  COMMAND ${CMAKE_COMMAND} -DINPUT=${own}/candelabra.metainfo.xml -DOUTPUT=${metainfo}
          -DPICTURES=${CANDELABRA_PICTURES_URL} -P ${own}/metainfo.cmake
  DEPENDS ${own}/candelabra.metainfo.xml ${own}/metainfo.cmake
  VERBATIM)
add_custom_target(metainfo ALL DEPENDS ${metainfo})
install(FILES ${own}/candelabra.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${metainfo} DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${own}/candelabra-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME candelabra.xml)
install(FILES ${own}/copyright README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The extension of VS Code, as a folder and as a package. Other editors take its grammar alone.
set(vscode ${CMAKE_BINARY_DIR}/vscode)
set(vsix ${CMAKE_BINARY_DIR}/candelabra-${PROJECT_VERSION}.vsix)
configure_file(${own}/vscode/package.json ${vscode}/package.json @ONLY)
set(parts ${vscode}/package.json)
foreach(part extension.js client.js commands.js preview.js language-configuration.json snippets.json)
  configure_file(${own}/vscode/${part} ${vscode}/${part} COPYONLY)
  list(APPEND parts ${vscode}/${part})
endforeach()
set(grammar ${vscode}/pov.tmLanguage.json)
add_custom_command(OUTPUT ${grammar} COMMAND candelabra --describe textmate > ${grammar} DEPENDS candelabra VERBATIM)
add_custom_command(
  OUTPUT ${vsix}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${vscode} -DOUTPUT=${vsix} -DVERSION=${PROJECT_VERSION} -P ${own}/vsix.cmake
  DEPENDS ${parts} ${grammar} ${own}/vsix.cmake
  VERBATIM)
add_custom_target(vsix ALL DEPENDS ${vsix})
install(FILES ${parts} ${grammar} DESTINATION ${CMAKE_INSTALL_DATADIR}/candelabra/vscode)
install(FILES ${vsix} DESTINATION ${CMAKE_INSTALL_DATADIR}/candelabra)

# The grammar for editors that use tree-sitter, whose own program makes a parser of it.
set(tree_sitter ${CMAKE_BINARY_DIR}/tree-sitter)
if(Python3_FOUND)
  add_custom_command(
    OUTPUT ${tree_sitter}/grammar.js
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/grammar/tree_sitter.py $<TARGET_FILE:candelabra> ${tree_sitter}
    DEPENDS candelabra ${CMAKE_SOURCE_DIR}/grammar/tree_sitter.py ${CMAKE_SOURCE_DIR}/grammar/scene.yy
            ${CMAKE_SOURCE_DIR}/grammar/tokens.re
    VERBATIM)
  add_custom_target(tree_sitter ALL DEPENDS ${tree_sitter}/grammar.js)
  install(DIRECTORY ${tree_sitter} DESTINATION ${CMAKE_INSTALL_DATADIR}/candelabra)
endif()

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME candelabra)
set(CPACK_PACKAGE_CONTACT "The authors of Candelabra <candelabra@localhost>")
set(CPACK_PACKAGE_FILE_NAME candelabra-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The libraries that the program opens itself lie in a folder of their own.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS fonts-povray)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Renders scenes written in the manner of POV-Ray. Every object that glows lights
 the others; light is sampled so that a scene with thousands of lamps is a matter
 of seconds.")
include(CPack)
