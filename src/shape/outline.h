// SPDX-License-Identifier: GPL-3.0-or-later
// An area of the plane between closed curves: what prism, text and polygon are swept from or cut
// out of. A point belongs to it when a way to the outside crosses the curves an odd number of
// times.
#pragma once

#include "shape/curve.h"

class Outline {
public:
    Outline() = default;
    explicit Outline(const std::vector<std::vector<CurvePiece>>& loops);

    bool contains(const Vec2&) const;
    const Rectangle& bounds() const { return bounds_; }

    /// A piece with the side on which the outside is.
    struct Edge {
        CurvePiece piece;
        Rectangle bounds;
        bool outside_right = true;  ///< of the direction in which u grows

        /// Unit vector to the outside.
        Vec2 normal(double u) const;
    };
    const std::vector<Edge>& edges() const { return edges_; }

private:
    /// A part of an edge along which y only grows or only falls.
    struct Strand {
        std::uint32_t edge;
        Interval u;
        double y_first, y_last, x_low, x_high;
    };
    void add_strands(std::uint32_t edge);
    bool right_of(const Strand&, const Vec2&) const;

    std::vector<Edge> edges_;
    std::vector<Strand> strands_;
    Rectangle bounds_;
};
