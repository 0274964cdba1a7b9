// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/adaptive.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

std::uint32_t samples_to_add(const Film& film, int x, int y, const AdaptiveRule& rule) {
    double deviation = 0;
    for (int v = std::max(0, y - 1); v <= std::min(film.height() - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(film.width() - 1, x + 1); ++u)
            if ((u != x || v != y) && film.at(u, v).samples > 1)
                deviation = std::max(deviation, film.at(u, v).deviation());
    const double ratio = deviation / rule.error;
    const double needed = ratio * ratio;
    const std::uint32_t has = film.at(x, y).samples;
    const double total = std::min(std::ceil(needed), static_cast<double>(rule.at_most));
    return total > has ? static_cast<std::uint32_t>(total) - has : 0;
}

}  // namespace candelabra
