# SPDX-License-Identifier: GPL-3.0-or-later
# Makes a .vsix, the package of an extension of VS Code, from a folder with its files: a zip with two descriptions more.
# It needs nothing but CMake.
#   cmake -DFOLDER=vscode -DOUTPUT=candelabra.vsix -DVERSION=1.2.3 -P vsix.cmake
get_filename_component(place ${OUTPUT} DIRECTORY)
set(stage ${place}/vsix)
file(REMOVE_RECURSE ${stage})
file(MAKE_DIRECTORY ${stage})
file(COPY ${FOLDER}/ DESTINATION ${stage}/extension)
file(WRITE "${stage}/[Content_Types].xml" [=[<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
  <Default Extension=".json" ContentType="application/json"/>
  <Default Extension=".js" ContentType="application/javascript"/>
  <Default Extension=".vsixmanifest" ContentType="text/xml"/>
</Types>
]=])
file(READ ${FOLDER}/package.json facts)
foreach(fact displayName description)
  string(JSON ${fact} GET "${facts}" ${fact})
endforeach()
string(JSON engine GET "${facts}" engines vscode)
file(WRITE ${stage}/extension.vsixmanifest "<?xml version=\"1.0\" encoding=\"utf-8\"?>
<PackageManifest Version=\"2.0.0\" xmlns=\"http://schemas.microsoft.com/developer/vsx-schema/2011\">
  <Metadata>
    <Identity Language=\"en-US\" Id=\"candelabra\" Version=\"${VERSION}\" Publisher=\"candelabra\"/>
    <DisplayName>${displayName}</DisplayName>
    <Description xml:space=\"preserve\">${description}</Description>
    <Tags>pov,snippet,__ext_pov,__ext_inc</Tags>
    <Categories>Programming Languages,Snippets</Categories>
    <Properties>
      <Property Id=\"Microsoft.VisualStudio.Code.Engine\" Value=\"${engine}\"/>
      <Property Id=\"Microsoft.VisualStudio.Code.ExtensionDependencies\" Value=\"\"/>
      <Property Id=\"Microsoft.VisualStudio.Code.ExtensionPack\" Value=\"\"/>
      <Property Id=\"Microsoft.VisualStudio.Code.ExtensionKind\" Value=\"workspace\"/>
    </Properties>
  </Metadata>
  <Installation>
    <InstallationTarget Id=\"Microsoft.VisualStudio.Code\"/>
  </Installation>
  <Dependencies/>
  <Assets>
    <Asset Type=\"Microsoft.VisualStudio.Code.Manifest\" Path=\"extension/package.json\" Addressable=\"true\"/>
  </Assets>
</PackageManifest>
")
file(REMOVE ${OUTPUT})
# The same files give the same bytes at any time.
execute_process(
  COMMAND ${CMAKE_COMMAND} -E tar cf ${OUTPUT} --format=zip "--mtime=1980-01-02 00:00:00 UTC"
          [Content_Types].xml extension.vsixmanifest extension
  WORKING_DIRECTORY ${stage}
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${OUTPUT} cannot be made: ${failed}")
endif()
file(REMOVE_RECURSE ${stage})
