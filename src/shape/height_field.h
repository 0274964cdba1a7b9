// SPDX-License-Identifier: GPL-3.0-or-later
// A landscape over the unit square: the heights of a picture's pixels or of a function. The reader
// of the language fills in the heights; rays are tested against the BuiltHeightField.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "base/transform.h"
#include "vocabulary/item_info.h"

#include <cstdint>

namespace candelabra {

/// Heights in units of 1/65536, row by row from z = 0, with x along the rows.
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
    std::string kind;  ///< the word before the file's name, such as `png`; empty: none
    Handle<Formula> function;
    double water_level = 0;
    bool smooth = false;
    bool hierarchy = true;
    double gamma = 0;
    Handle<HeightGrid> grid;

    static const ItemInfo vocabulary;
};

/// Minimum and maximum height of a block of cells, in units of 1/65536.
struct HeightBlock {
    std::uint16_t low, high;
};

/// The cells of a grid, grouped in square blocks of size by size cells.
struct HeightBlocks {
    int size = 0;
    int columns = 0;
    std::vector<HeightBlock> blocks;  ///< row by row

    /// The block that contains a cell.
    const HeightBlock& at(int x, int z) const {
        return blocks[static_cast<std::size_t>(z / size * columns + x / size)];
    }
};

struct BuiltHeightField {
    Handle<HeightGrid> grid;
    double water_level = 0;
    bool smooth = false;
    double low = 0, high = 0;               ///< minimum and maximum height, up to 1
    std::vector<HeightBlocks> levels = {};  ///< from the smallest blocks to the largest
    /// Transform of a smooth height field that it stretches. As in POV-Ray, the pixels' normals
    /// have length 1 in the space after the transform when they are interpolated, not in the unit
    /// square. Null: none.
    Handle<Transform> stretched = nullptr;
};

/// Error that the ranges of single fields do not exclude (no heights), as a sentence; empty when
/// there is none.
std::string problem(const HeightField&);
std::string vanishes(const HeightField&);
BuiltHeightField build(const HeightField&);

/// The surface is the landscape only; everything below it is inside.
Box bounds(const BuiltHeightField&);
/// See crossings_in() of BuiltShape.
void nearest_crossings(const BuiltHeightField&, const Ray&, const Interval& range, Crossings&);
void crossings(const BuiltHeightField&, const Ray&, Crossings&);
bool inside(const BuiltHeightField&, const Vec3&);
Box inside_bounds(const BuiltHeightField&);

}  // namespace candelabra
