// SPDX-License-Identifier: GPL-3.0-or-later
// Place of a value in a map: the entries around it, and the fraction between them. Shared by maps
// of colours, pigments, normals and slopes.
#pragma once

#include <cstddef>
#include <vector>

namespace candelabra {

/// Blends entry `below` with entry `above` by the weight `share` of the latter. At a single entry,
/// both are equal to it and the share is 0.
struct MapPlace {
    std::size_t below = 0;
    std::size_t above = 0;
    double share = 0;
};

/// Returns the first entry below the map's values, the last one above them, and linear
/// interpolation between. Where entries share a value, the first one counts at the value itself and
/// the last one just above it. Precondition: the map is not empty, and each entry has a `value`, in
/// textual order.
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
