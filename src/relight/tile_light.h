// SPDX-License-Identifier: GPL-3.0-or-later
// The light of each lamp in a tile while samples are made. It comes lamp by lamp; what would take
// too much memory is summed by nodes of lamps.
#pragma once

#include "base/rgb.h"
#include "relight/tile_records.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The pixels of a tile when all samples have been made.
struct TilePixels {
    std::array<double, tile_pixels> weight{};  ///< divisor of sums; 0: no samples
    std::array<Rgb, tile_pixels> mean{};       ///< of all light
};

class TileLight {
public:
    /// Takes light of a lamp, by its place in the list. What is not finite is left out.
    void add(std::uint32_t lamp, std::size_t pixel, const Rgb& light, bool seen);

    /// Whether so much has been added that settle() should be called.
    bool crowded() const { return fresh_.size() >= most_fresh; }

    /// Brings what has been added to its place, within so many bytes. `seed`: of random numbers.
    void settle(const LampList&, std::size_t bytes, std::uint64_t seed);

    /// Returns the records of a tile that has all its samples, within so many bytes. Nothing is
    /// left of the tile.
    TileRecords finished(const LampList&, const TilePixels&, std::size_t bytes, std::uint64_t seed);

    /// Appends the bytes of all that it holds, from which another run goes on.
    void append_to(std::string& bytes) const;
    /// Takes it from the front of the bytes. Returns nothing if they are not those of a tile with
    /// this number of lamps.
    static std::optional<TileLight> take(std::string_view& bytes, std::uint32_t lamps);

private:
    static constexpr std::size_t most_fresh = std::size_t{1} << 16;

    struct Node {
        LampRange range;
        TilePlanes light{};
    };

    Node* node_of(std::uint32_t lamp);
    void place(const LampEntry&);
    void shrink(const LampList&, std::size_t bytes, std::uint64_t seed);
    void demote(std::size_t most);
    std::vector<LampAtom> atoms() const;
    void gather(const std::vector<LampRange>&);
    std::size_t bytes_of_own() const { return own_.size() * entry_bytes; }
    std::size_t bytes() const {
        return nodes_.size() * node_bytes + bytes_of_own() + residual_.size() * entry_bytes;
    }

    std::vector<LampEntry> fresh_;     ///< in any order
    std::vector<Node> nodes_;          ///< disjoint, in the order of the list
    std::vector<LampEntry> own_;       ///< see TileRecords, and sorted
    std::vector<LampEntry> residual_;  ///< likewise
    bool seen_in_nodes_ = false;       ///< see TileRecords
};

}  // namespace candelabra
