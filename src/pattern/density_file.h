// SPDX-License-Identifier: GPL-3.0-or-later
// Values from a file: a box of numbers in POV-Ray's df3 format, stretched over the unit cube.
#pragma once

#include "base/handle.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The numbers of a file, from 0 to 1, x fastest.
struct DensityGrid {
    std::array<std::size_t, 3> size{};
    std::vector<float> values;
};

/// Reads a file's content: three sizes of two bytes, then all values of 1, 2 or 4 bytes each, high
/// byte first. Nothing when the length does not fit, or a size is 0.
std::optional<DensityGrid> read_density_grid(std::string_view content);

struct DensityFile {
    std::string df3;
    int interpolate = 0;
    Handle<DensityGrid> grid;  ///< what the file holds; null: 0 everywhere

    static const ItemInfo vocabulary;
};

double evaluate(const DensityFile&, const Vec3& point);

}  // namespace candelabra
