// SPDX-License-Identifier: GPL-3.0-or-later
// A page to share: one HTML file with a picture whose lamps can be mixed anew. It has the light of
// each lamp, and asks for nothing from anywhere, which its Content-Security-Policy states; a page
// that a server makes asks this server for its successor. Its
// files are in src/preview/page and are embedded into the program by the build.
#pragma once

#include "camera/film_settings.h"
#include "picture/light_code.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

extern const std::string_view share_frame, share_style, share_script, share_watch;

/// A show that the page plays, for which the layers of light are that of crowds of lamps, that of
/// none, and those of some lamps; see relight/page_records.h.
struct SharedShow {
    int columns = 0, rows = 0;          ///< cells
    int cell = 0;                       ///< pixels along the sides of a cell
    std::vector<std::uint32_t> groups;  ///< numbers of lamps, in the order of the list
    std::vector<std::uint32_t> strong;  ///< places of lamps that have layers of light
    std::size_t frames = 1;
    double rate = 0;                        ///< frames a second
    double scale = 1;                       ///< the greatest factor of a lamp
    bool grey = true;                       ///< frames have a byte of each lamp, otherwise three
    std::array<std::size_t, 4> sizes = {};  ///< of cells, dots, powers and frames, unpacked
    std::string bytes;                      ///< these, packed by zlib
};

struct SharedPicture {
    std::string title;               ///< any text; the page shows it as it is
    std::string name;                ///< of files that the page saves, without an ending
    int width = 0, height = 0;       ///< of the picture
    std::vector<std::string> lamps;  ///< names of the light in the code, in its order
    LightCode light;                 ///< with glare and vignette
    FilmSettings film;
    double exposure = 0;  ///< in stops, including automatic exposure
    /// Its groups are the first lamps, and behind those that have one comes `rest`.
    std::optional<SharedShow> show = {};
    /// Number of the page, from 1 on, if a server makes it anew when its files change; 0: the page
    /// stands by itself.
    int watched = 0;
};

/// Returns the page. The name `rest` is shown as light without a lamp.
std::string share_page(const SharedPicture&);

/// Returns the number of bytes of light with which a page of these lamps has `page_bytes` in all.
std::size_t room_for_light(const SharedPicture&, std::size_t page_bytes);

}  // namespace candelabra
