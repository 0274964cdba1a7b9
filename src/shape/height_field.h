// SPDX-License-Identifier: GPL-3.0-or-later
// A landscape over the unit square: the heights of a picture's pixels, or of a function. The reader
// of the language puts in the heights; rays ask the BuiltHeightField.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "base/transform.h"
#include "vocabulary/item_info.h"

#include <cstdint>

namespace candelabra {

/// Heights in units of 1/65536, row by row from z = 0, x along the rows.
struct HeightGrid {
    int width = 0, height = 0;
    std::vector<std::uint16_t> values;

    std::uint16_t at(int x, int z) const {
        return values[static_cast<std::size_t>(z) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

struct HeightField {
    std::string file;
    Handle<Formula> function;
    double water_level = 0;
    bool smooth = false;
    bool hierarchy = true;
    double gamma = 0;
    Handle<HeightGrid> grid;

    static const ItemInfo vocabulary;
};

/// The lowest and the highest height of some cells, in units of 1/65536.
struct HeightBlock {
    std::uint16_t low, high;
};

/// All cells of a grid in squares of so many cells each way.
struct HeightBlocks {
    int size = 0;
    int columns = 0;
    std::vector<HeightBlock> blocks;  ///< row by row

    /// That of a cell.
    const HeightBlock& at(int x, int z) const {
        return blocks[static_cast<std::size_t>(z / size * columns + x / size)];
    }
};

struct BuiltHeightField {
    Handle<HeightGrid> grid;
    double water_level = 0;
    bool smooth = false;
    double low = 0, high = 0;               ///< of all heights, up to 1
    std::vector<HeightBlocks> levels = {};  ///< from the smallest blocks on
    /// The place of a smooth one that is stretched there: as in POV-Ray, the normals of pixels are
    /// of length 1 there when they are mixed, not in the unit square. Null: none.
    Handle<Transform> stretched = nullptr;
};

/// What is wrong beyond the ranges of single fields (no heights), as a sentence; empty when nothing
/// is.
std::string problem(const HeightField&);
BuiltHeightField build(const HeightField&);

/// Only the landscape is a surface; below it everything is inside.
Box bounds(const BuiltHeightField&);
/// See crossings_in() of BuiltShape.
void nearest_crossings(const BuiltHeightField&, const Ray&, const Interval& range, Crossings&);
void crossings(const BuiltHeightField&, const Ray&, Crossings&);
bool inside(const BuiltHeightField&, const Vec3&);
Box inside_bounds(const BuiltHeightField&);

}  // namespace candelabra
