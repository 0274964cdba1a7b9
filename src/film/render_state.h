// SPDX-License-Identifier: GPL-3.0-or-later
// A picture that is being made.
#pragma once

#include "film/film.h"
#include "film/picture_shard.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace candelabra {

/// An unfinished picture.
struct RenderState {
    Film film;
    PictureShard shard;
    std::uint32_t rounds = 0;  ///< planned so far

    friend bool operator==(const RenderState&, const RenderState&) = default;
};

/// Totals of the planned samples so far.
struct Wanted {
    std::uint64_t samples = 0;
    std::uint64_t missing = 0;  ///< those not yet taken
    std::uint32_t most = 0;     ///< in one pixel

    void add(const PixelSum& pixel) {
        samples += pixel.planned;
        if (pixel.planned > pixel.samples) missing += pixel.planned - pixel.samples;
        most = std::max(most, pixel.planned);
    }
};

inline Wanted wanted_samples(const Film& film) {
    Wanted all;
    film.each([&](std::size_t i) { all.add(film.pixels()[i]); });
    return all;
}

/// Calls use(x, y, pixel) for the pixels of a region, row by row.
template <class Use>
void for_pixels(Film& film, const Region& region, const Use& use) {
    for (int y = region.top; y < region.bottom; ++y)
        for (int x = region.left; x < region.right; ++x) use(x, y, film.at(x, y));
}

/// The same for all pixels in the rows that the film keeps to.
template <class Use>
void for_pixels(Film& film, const Use& use) {
    int x = 0, y = film.first_row();
    film.each([&](std::size_t i) {
        use(x, y, film.pixels()[i]);
        if (++x < film.width()) return;
        x = 0;
        ++y;
    });
}

}  // namespace candelabra
