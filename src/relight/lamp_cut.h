// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of what a tile of a picture keeps: which ranges of lamps count together, and which
// single records stand for many.
#pragma once

#include "relight/lamp_list.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

/// Lamps that a tile cannot tell apart, or a single lamp, and the amount of their light.
struct LampAtom {
    LampRange range;
    double light = 0;
};

/// Returns at most `most` disjoint nodes that hold all atoms: those with much light are divided
/// first. The atoms are sorted, and each is a node or a lamp. A node with one atom is this atom.
std::vector<LampRange> chosen_nodes(const LampList&, std::span<const LampAtom>, std::size_t most);

/// The light of one lamp in one pixel of a tile.
struct LampEntry {
    std::uint32_t lamp = 0;  ///< its place in the list
    std::uint8_t pixel = 0;  ///< row by row in the tile
    bool seen = false;       ///< that a ray met
    std::array<float, 3> light{};

    /// By pixel, then by lamp.
    std::uint64_t key() const {
        return std::uint64_t{pixel} << 33 | std::uint64_t{lamp} << 1 | (seen ? 1 : 0);
    }
    /// The greatest of the channels.
    float size() const;

    friend bool operator==(const LampEntry&, const LampEntry&) = default;
};

/// Keeps about `most` of the entries, never more, and gives them the weight of the others: any sum
/// over the entries with factors keeps its expected value. Large entries stay as they are. `random`
/// is a number in [0, 1).
void thin(std::vector<LampEntry>&, std::size_t most, double random);

/// Returns the entries in the order of their keys, with one for each key.
std::vector<LampEntry> summed(std::vector<LampEntry>);

}  // namespace candelabra
