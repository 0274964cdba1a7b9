// SPDX-License-Identifier: GPL-3.0-or-later
// Where a value lies in a map: between which entries, and how far. The same for maps of colours,
// pigments, normals and slopes.
#pragma once

#include <cstddef>
#include <vector>

namespace candelabra {

/// The result is entry `below` and, by the share, entry `above`; the share is 0 where one entry
/// counts alone, and both are it.
struct MapPlace {
    std::size_t below = 0;
    std::size_t above = 0;
    double share = 0;
};

/// The first entry below all, the last above all; between two entries linear. Where entries share a
/// value, the first counts at the value itself and the last just above it. Precondition: not empty,
/// and each entry has a `value`, in the order of the text.
template <class Entry>
MapPlace place_in(const std::vector<Entry>& map, double value) {
    const std::size_t last = map.size() - 1;
    if (value >= map[last].value) return {last, last, 0};
    std::size_t next = 0;
    while (next < last && value > map[next].value) ++next;
    if (next == 0 || value == map[next].value) return {next, next, 0};
    const double start = map[next - 1].value;
    return {next - 1, next, (value - start) / (map[next].value - start)};
}

}  // namespace candelabra
