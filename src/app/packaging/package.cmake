# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed for desktops and packagers, and the .deb: cpack -G DEB in the build folder.
set(own ${CMAKE_CURRENT_LIST_DIR})
install(FILES ${own}/candelabra.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${own}/candelabra.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${own}/candelabra-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME candelabra.xml)
install(FILES ${own}/copyright README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Colours for editors. The folder is an extension of VS Code; others take the grammar alone.
set(grammar ${CMAKE_BINARY_DIR}/pov.tmLanguage.json)
add_custom_command(OUTPUT ${grammar} COMMAND candelabra --describe textmate > ${grammar} DEPENDS candelabra VERBATIM)
add_custom_target(textmate ALL DEPENDS ${grammar})
install(FILES ${own}/vscode/package.json ${own}/vscode/language-configuration.json
              ${own}/vscode/extension.js ${own}/vscode/client.js ${grammar}
        DESTINATION ${CMAKE_INSTALL_DATADIR}/candelabra/vscode)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME candelabra)
set(CPACK_PACKAGE_CONTACT "The authors of Candelabra <candelabra@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The libraries that the program opens itself lie in a folder of their own.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS fonts-povray)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS ffmpeg)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Renders scenes written in the manner of POV-Ray. Every object that glows lights
 the others; light is sampled so that a scene with thousands of lamps is a matter
 of seconds.")
include(CPack)
