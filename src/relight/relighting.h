// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the light of each lamp under other powers and colours.
#pragma once

#include "base/image.h"
#include "relight/light_records.h"
#include "relight/smooth_crowds.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candelabra {

class Relighting {
public:
    /// `smooth`: how far around a pixel, in pixels, the light of crowds of lamps is compared with
    /// what it was, so that it has less noise. 0: not at all; each pixel has the right expected
    /// value then. The records must outlive it.
    Relighting(const LightRecords&, int smooth, int threads);

    /// Returns the picture with these factors on the lamps, by their places in the list; 1 is a
    /// lamp as it was rendered.
    Image picture(std::span<const Rgb> factors) const;

private:
    bool is_smooth(const TileRecords& tile) const { return crowds_ && !tile.seen_in_nodes; }
    void add_light(std::size_t tile, const FactorMeans&, std::span<const Channels>,
                   TilePlanes&) const;

    const LightRecords& records_;
    int threads_;
    std::optional<SmoothCrowds> crowds_;
    /// Of each sample of a lamp in a crowd, tile by tile: its node. Empty where it is smooth.
    std::vector<std::vector<std::uint32_t>> node_of_;
};

/// Returns a picture whose pixels have the right expected values.
Image relit(const LightRecords&, std::span<const Rgb> factors, int threads);

}  // namespace candelabra
