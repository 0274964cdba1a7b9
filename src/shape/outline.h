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
    /// Calls use(edge) for the edges whose bounds beside(Rectangle) is false for; it is asked about
    /// groups of them first.
    template <class Beside, class Use>
    void for_edges(Beside beside, Use use) const {
        for (std::size_t group = 0; group < groups_.size(); ++group) {
            if (beside(groups_[group])) continue;
            const std::size_t last = std::min(edges_.size(), (group + 1) * group_size);
            for (std::size_t i = group * group_size; i < last; ++i)
                if (!beside(edges_[i].bounds)) use(edges_[i]);
        }
    }

private:
    /// A part of an edge along which y only grows or only falls.
    struct Strand {
        std::uint32_t edge;
        Interval u;
        double y_first, y_last, x_low, x_high;
    };
    void add_strands(std::uint32_t edge);
    bool right_of(const Strand&, const Vec2&) const;

    static constexpr std::size_t group_size = 16;

    std::vector<Edge> edges_;
    std::vector<Rectangle> groups_;  ///< around so many edges each
    std::vector<Strand> strands_;
    Rectangle bounds_;
};
