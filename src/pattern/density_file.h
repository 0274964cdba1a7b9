// SPDX-License-Identifier: GPL-3.0-or-later
// Values from a file: a grid of numbers in POV-Ray's df3 format, stretched over the unit cube.
#pragma once

#include "base/handle.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The numbers of a file, scaled to 0..1; x varies fastest.
struct DensityGrid {
    std::array<std::size_t, 3> size{};
    std::vector<float> values;
};

/// Parses a file's content: three sizes of two bytes, then all values of 1, 2 or 4 bytes each, high
/// byte first. Returns nothing if the length does not match or a size is 0.
std::optional<DensityGrid> read_density_grid(std::string_view content);

struct DensityFile {
    std::string df3;
    int interpolate = 0;
    Handle<DensityGrid> grid;  ///< the values of the file; null: 0 everywhere

    static const ItemInfo vocabulary;
};

double evaluate(const DensityFile&, const Vec3& point);

}  // namespace candelabra
