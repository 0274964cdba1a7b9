// SPDX-License-Identifier: GPL-3.0-or-later
// A plane area bounded by closed curves, which prism and text sweep and polygon cuts out. By the
// even-odd rule, a point belongs to it when a path to the outside crosses the curves an odd number
// of times.
#pragma once

#include "shape/curve.h"

namespace candelabra {

class Outline {
public:
    Outline() = default;
    explicit Outline(const std::vector<std::vector<CurvePiece>>& loops);

    bool contains(const Vec2&) const;
    const Rectangle& bounds() const { return bounds_; }

    /// A piece with the side on which the outside lies.
    struct Edge {
        CurvePiece piece;
        Rectangle bounds;
        bool outside_right = true;  ///< of the direction of increasing u

        /// Outward unit normal.
        Vec2 normal(double u) const;
    };
    /// Calls use(edge) for the edges for whose bounds beside(Rectangle) returns false. It is called
    /// for the bounds of groups of edges first.
    template <class Beside, class Use>
    void for_edges(Beside beside, Use use) const {
        for (const Loop& loop : loops_) {
            if (beside(loop.bounds)) continue;
            for (std::uint32_t group = loop.groups.first; group < loop.groups.last; ++group) {
                if (beside(groups_[group].bounds)) continue;
                const Range edges = groups_[group].edges;
                for (std::uint32_t i = edges.first; i < edges.last; ++i)
                    if (!beside(edges_[i].bounds)) use(edges_[i]);
            }
        }
    }

private:
    /// A part of an edge along which y is monotonic.
    struct Strand {
        std::uint32_t edge;
        Interval u;
        double y_first, y_last, x_low, x_high;
    };
    struct Range {
        std::uint32_t first, last;  ///< half-open: `last` is excluded
    };
    /// Neighbouring edges of a curve.
    struct Group {
        Rectangle bounds;
        Range edges, strands;
    };
    struct Loop {
        Rectangle bounds;
        Range groups;
    };
    void add(const std::vector<CurvePiece>& loop);
    void add_strands(std::uint32_t edge);
    bool right_of(const Strand&, const Vec2&) const;

    static constexpr std::size_t group_size = 16;

    std::vector<Edge> edges_;
    std::vector<Strand> strands_;
    std::vector<Group> groups_;
    std::vector<Loop> loops_;
    Rectangle bounds_;
};

}  // namespace candelabra
