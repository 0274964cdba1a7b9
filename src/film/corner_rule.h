// SPDX-License-Identifier: GPL-3.0-or-later
// Deterministic antialiasing, as in POV-Ray's second method: rays through the corners of a pixel,
// and recursively through those of its quarters where corners differ. The resulting colour is a
// single sample of the film.
#pragma once

#include "film/contrast.h"
#include "film/rule_kind.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace candelabra {

struct CornerRule {
    Contrast contrast;
    int depth;      ///< a pixel is quartered at most depth - 1 times
    double jitter;  ///< maximum random offset of rays inside, as a fraction of the least distance

    static std::optional<CornerRule> chosen(const RuleChoice&);
    static DecidedBy decided_by(const RenderSettings&) { return DecidedBy::tile; }
    static int first(const FirstSamples&) { return 1; }
    static std::uint32_t most(const RenderSettings&, std::uint32_t first) { return first; }
    static void refine(RenderState&, const RenderSettings&) {}
    /// Samples are numbered row by row; rows and columns have one sample more than quarters.
    /// Corners are not jittered.
    std::optional<Vec2> place(const Key&) const;
    std::uint64_t make(TileSamples&, std::uint32_t level) const;

    /// Number of the smallest quarters along an edge of a pixel.
    std::uint32_t quarters_across() const { return std::uint32_t{1} << (depth - 1); }
};

CornerRule corner_rule(const RenderSettings&, double assumed_gamma, double exposure = 1);

/// The pixels of a tile, which share their corners.
class CornerCells {
public:
    /// Returns the values of a sample's ray; the pixel may lie one beyond the end of a row or
    /// column.
    using Look = FunctionRef<PixelSample(int x, int y, std::uint32_t sample)>;

    CornerCells(const CornerRule&, const Region& tile);

    /// Returns the sample of a pixel. Its shadow rays are those of its first corner and of its
    /// inside.
    PixelSample pixel(int x, int y, Look look);

private:
    struct Point {
        PixelSample sight;
        DisplayValue shown;
    };
    /// A square in the current pixel: position from its left and upper edge and size, in smallest
    /// quarters.
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
    std::unordered_map<std::uint32_t, Point> inside_;  ///< rays of one pixel by sample
};

}  // namespace candelabra
