// SPDX-License-Identifier: GPL-3.0-or-later
// What a sample rule needs of the renderer while a tile is made.
#pragma once

#include "base/rgb.h"
#include "film/render_state.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace candelabra {

/// The values of one ray, or the mean of several.
struct PixelSample {
    Rgb colour = Rgb(0);
    double clear = 0;  ///< transparency to compare, if the picture has an alpha channel
    std::vector<double> extra = {};  ///< the film's further sums
    std::uint32_t shadow_rays = 0;
};

/// A tile whose samples are being made.
class TileSamples {
public:
    TileSamples(RenderState& state, const Region& region) : state_(state), region_(region) {}
    virtual ~TileSamples() = default;
    TileSamples(const TileSamples&) = delete;
    TileSamples& operator=(const TileSamples&) = delete;

    const Region& region() const { return region_; }
    /// The part of the tile inside of the shard's rectangle.
    Region own() const { return common(region_, state_.shard.region); }
    Film& film() const { return state_.film; }

    /// Brings a pixel to a number of samples, unless the work is stopped before. Returns how many
    /// it made.
    virtual std::uint64_t bring(int x, int y, std::uint32_t samples) = 0;
    /// Follows the ray of a sample without adding it to a pixel. The pixel may lie outside of the
    /// tile and of the picture.
    virtual PixelSample look(int x, int y, std::uint32_t sample) = 0;
    /// Gives a pixel its only sample, which is made of many rays.
    virtual void add(int x, int y, const PixelSample&) = 0;
    /// Transparency of a pixel, if the picture has an alpha channel, or 0.
    virtual double clear(int x, int y) const = 0;
    /// Whether the work is to stop.
    virtual bool stopped() = 0;

    /// Brings all pixels to their planned samples, or to `level` samples if that is less. Returns
    /// how many samples it made.
    std::uint64_t bring_all(std::uint32_t level) {
        std::uint64_t made = 0;
        for_pixels(film(), region_, [&](int x, int y, const PixelSum& pixel) {
            made += bring(x, y, std::min(level, pixel.planned));
        });
        return made;
    }

private:
    RenderState& state_;
    Region region_;
};

}  // namespace candelabra
