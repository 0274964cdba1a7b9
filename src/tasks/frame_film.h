// SPDX-License-Identifier: GPL-3.0-or-later
// The film of one picture among several.
#pragma once

#include "camera/film_settings.h"
#include "options/options.h"

#include <cstdint>

namespace candelabra {

/// Returns the film with a grain pattern of its own for each picture.
inline FilmSettings film_of_frame(FilmSettings film, const Options& options) {
    constexpr std::uint32_t most = (1u << 30) - 1;
    if (film.grain > 0)
        film.grain_seed =
            static_cast<int>((static_cast<std::uint32_t>(film.grain_seed) +
                              static_cast<std::uint32_t>(options.render.seed) +
                              static_cast<std::uint32_t>(options.facts.frame_number)) &
                             most);
    return film;
}

}  // namespace candelabra
