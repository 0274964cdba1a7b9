// SPDX-License-Identifier: GPL-3.0-or-later
// A film that is filled without tracing, for tests of sample rules.
#pragma once

#include "film/schedule.h"

namespace candelabra {

inline RenderSettings tiny_picture() {
    RenderSettings settings;
    settings.width = 36;
    settings.height = 34;
    return settings;
}

/// Takes all wanted samples: grey on the left; alternately black and white on the right.
inline void take_wanted(Film& film) {
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x)
            for (PixelSum& p = film.at(x, y); p.samples < p.planned;)
                p.add(Rgb(x < 10 ? 0.5 : p.samples % 2));
}

}  // namespace candelabra
