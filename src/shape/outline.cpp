// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/outline.h"

#include "base/elementary.h"
#include "base/work_watch.h"

#include <algorithm>

namespace candelabra {

namespace {

double length(const Vec2& v) { return math::hypot(v.x, v.y); }

Vec2 right_of(const Vec2& direction) { return {direction.y, -direction.x}; }

}  // namespace

Vec2 Outline::Edge::normal(double u) const {
    Vec2 slope = piece.slope(u);
    if (slope == Vec2(0)) slope = piece.end - piece.start;
    const Vec2 right = candelabra::right_of(slope) / length(slope);
    return outside_right ? right : -right;
}

Outline::Outline(const std::vector<std::vector<CurvePiece>>& loops) {
    for (const auto& loop : loops) add(loop);
    // A curve that does not cross itself has the outside on one side all along. It is determined
    // beside the longest piece of each curve.
    auto first = edges_.begin();
    for (const auto& loop : loops) {
        const auto last = first + static_cast<std::ptrdiff_t>(loop.size());
        const auto longest = std::max_element(first, last, [](const Edge& a, const Edge& b) {
            return length(a.bounds.high - a.bounds.low) < length(b.bounds.high - b.bounds.low);
        });
        if (longest == last) continue;
        const double aside = 1e-6 * length(longest->bounds.high - longest->bounds.low);
        const bool right_within = contains(longest->piece.at(0.5) + aside * longest->normal(0.5));
        for (auto edge = first; edge != last; ++edge) edge->outside_right = !right_within;
        first = last;
    }
}

void Outline::add(const std::vector<CurvePiece>& loop) {
    const auto count = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
    Loop all{{}, {count(groups_), count(groups_)}};
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (i % group_size == 0) groups_.push_back({{}, {count(edges_), 0}, {count(strands_), 0}});
        edges_.push_back({loop[i], candelabra::bounds(loop[i])});
        add_strands(count(edges_) - 1);
        Group& group = groups_.back();
        group.bounds = join(group.bounds, edges_.back().bounds);
        group.edges.last = count(edges_);
        group.strands.last = count(strands_);
        all.bounds = join(all.bounds, edges_.back().bounds);
    }
    all.groups.last = count(groups_);
    loops_.push_back(all);
    bounds_ = join(bounds_, all.bounds);
}

void Outline::add_strands(std::uint32_t edge) {
    const CurvePiece& piece = edges_[edge].piece;
    const std::array<double, 3> slope = {piece.factors[1].y, 2 * piece.factors[2].y,
                                         3 * piece.factors[3].y};
    double from = 0;
    Vec2 at = piece.start;
    const auto add = [&](double to, const Vec2& there) {
        // Where x turns within a strand, the curve is wider than its ends.
        const Rectangle& box = edges_[edge].bounds;
        const bool straight = piece.factors[2] == Vec2(0) && piece.factors[3] == Vec2(0);
        strands_.push_back({edge,
                            {from, to},
                            at.y,
                            there.y,
                            straight ? std::fmin(at.x, there.x) : box.low.x,
                            straight ? std::fmax(at.x, there.x) : box.high.x});
        from = to;
        at = there;
    };
    for (const double u : sign_changes(slope, {0, 1})) add(u, piece.at(u));
    add(1, piece.end);
}

bool Outline::right_of(const Strand& strand, const Vec2& p) const {
    if (p.x < strand.x_low) return true;
    if (p.x >= strand.x_high) return false;
    const CurvePiece& piece = edges_[strand.edge].piece;
    const auto height = piece.combined({0, 1}, -p.y);
    const Roots at = sign_changes(height, strand.u, strand.y_first - p.y, strand.y_last - p.y);
    return !at.empty() && piece.at(at[0]).x > p.x;
}

bool Outline::contains(const Vec2& p) const {
    bool result = false;
    for (const Loop& loop : loops_) {
        // From a point beside a closed curve, any path to the outside crosses it an even number of
        // times.
        const Rectangle& around = loop.bounds;
        if (!(p.x >= around.low.x && p.x <= around.high.x && p.y >= around.low.y &&
              p.y <= around.high.y))
            continue;
        constexpr std::uint32_t groups_of_step = 4;
        count_work((loop.groups.last - loop.groups.first) / groups_of_step);
        for (std::uint32_t g = loop.groups.first; g < loop.groups.last; ++g) {
            const auto& [box, edges, strands] = groups_[g];
            if (p.y < box.low.y || p.y > box.high.y || p.x >= box.high.x) continue;
            for (std::uint32_t i = strands.first; i < strands.last; ++i)
                if ((strands_[i].y_first < p.y) != (strands_[i].y_last < p.y))
                    result ^= right_of(strands_[i], p);
        }
    }
    return result;
}

}  // namespace candelabra
