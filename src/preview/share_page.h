// SPDX-License-Identifier: GPL-3.0-or-later
// A page to share: one HTML file with a picture whose lamps can be mixed anew. It has the light of
// each lamp, and asks for nothing from anywhere, which its Content-Security-Policy states. Its
// files are in src/preview/page and are embedded into the program by the build.
#pragma once

#include "camera/film_settings.h"
#include "picture/light_code.h"

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

extern const std::string_view share_frame, share_style, share_script;

struct SharedPicture {
    std::string title;               ///< any text; the page shows it as it is
    std::string name;                ///< of files that the page saves, without an ending
    int width = 0, height = 0;       ///< of the picture
    std::vector<std::string> lamps;  ///< names of the light in the code, in its order
    LightCode light;                 ///< with glare and vignette
    FilmSettings film;
    double exposure = 0;  ///< in stops, including automatic exposure
};

/// Returns the page. The name `rest` is shown as light without a lamp.
std::string share_page(const SharedPicture&);

/// Returns the number of bytes of light with which a page of these lamps has `page_bytes` in all.
std::size_t room_for_light(const SharedPicture&, std::size_t page_bytes);

}  // namespace candelabra
