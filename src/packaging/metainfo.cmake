# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the AppStream data. Its pictures are shown from the web only, so they are named where the address of a copy of
# examples/pictures/ is given; without one there are none.
#   cmake -DINPUT=candelabra.metainfo.xml -DOUTPUT=candelabra.metainfo.xml [-DPICTURES=https://...] -P metainfo.cmake
set(SCREENSHOTS "")
if(PICTURES)
  set(default " type=\"default\"")
  set(SCREENSHOTS "  <screenshots>")
  foreach(shown "fig6.png|7381 diffuse spheres beside 7381 luminaires"
                "preview.png|The preview shows the picture while the scene is written"
                "promenade.png|Lamps along a promenade, developed as a camera sees them")
    string(REGEX MATCH "^([^|]+)[|](.*)$" parts "${shown}")
    string(APPEND SCREENSHOTS "
    <screenshot${default}>
      <caption>${CMAKE_MATCH_2}</caption>
      <image>${PICTURES}/${CMAKE_MATCH_1}</image>
    </screenshot>")
    set(default "")
  endforeach()
  string(APPEND SCREENSHOTS "\n  </screenshots>")
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
