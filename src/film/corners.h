// SPDX-License-Identifier: GPL-3.0-or-later
// Antialiasing where nothing is left to chance, as POV-Ray's second method has it: rays through the
// corners of a pixel, and through those of its quarters where corners differ. The pixel's colour is
// one sample of the film, whatever it is made of.
#pragma once

#include "film/contrast.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace candelabra {

struct CornerRule {
    Contrast contrast;
    int depth;      ///< a pixel is quartered one time less than this
    double jitter;  ///< how far rays inside are moved at random, in parts of the least distance
};

CornerRule corner_rule(const RenderSettings&, double assumed_gamma, double exposure = 1);

/// How many of the smallest quarters are side by side in a pixel.
std::uint32_t quarters_across(const CornerRule&);

/// Where the ray of a sample passes its pixel, from the left and upper edge, in pixels. Samples are
/// numbered row by row: one more in a row, and rows, than quarters. Corners stay where they are.
Vec2 place_in_pixel(const CornerRule&, const Key&);

/// What one ray has shown, or the mean of several.
struct PixelSample {
    Vec3 colour = Vec3(0);
    double clear = 0;  ///< that is compared besides, where a picture has an alpha channel
    std::vector<double> extra = {};  ///< as the film's
    std::uint32_t shadow_rays = 0;
};

/// The pixels of a tile, which share their corners.
class CornerCells {
public:
    /// What the ray of a sample shows; the pixel may be one behind the last of a row, or below.
    using Look = FunctionRef<PixelSample(int x, int y, std::uint32_t sample)>;

    CornerCells(const CornerRule&, const Region& tile);

    /// Its shadow rays are those of its first corner and of what is inside.
    PixelSample pixel(int x, int y, Look look);

private:
    struct Point {
        PixelSample sight;
        DisplayValue shown;
    };
    /// A square in the pixel that is looked at: in smallest quarters from its left and upper edge.
    struct Cell {
        std::uint32_t x, y, size;
    };
    struct Pixel {
        int x, y;
        Look look;
    };

    const Point& point(const Pixel&, std::uint32_t x, std::uint32_t y);
    Point seen(const Pixel&, std::uint32_t sample) const;
    PixelSample mean(const Pixel&, const Cell&);

    CornerRule rule_;
    Region tile_;
    std::vector<std::optional<Point>> corners_;
    std::unordered_map<std::uint32_t, Point> inside_;  ///< of one pixel, by their sample
};

}  // namespace candelabra
