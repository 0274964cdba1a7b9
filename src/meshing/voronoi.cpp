// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/voronoi.h"

#include "base/long_work.h"
#include "base/order.h"

#include <algorithm>
#include <utility>

namespace candelabra {

namespace {

double square(const Vec2& v) { return dot(v, v); }

/// Another point. The greatest one is the nearest; of equally near ones, the first.
struct Neighbour {
    double distance2;
    std::size_t number;

    friend bool operator<(const Neighbour& a, const Neighbour& b) {
        return std::pair(b.distance2, b.number) < std::pair(a.distance2, a.number);
    }
};

/// The part of the polygon that is nearer to p than to q.
std::vector<Vec2> nearer(const std::vector<Vec2>& polygon, const Vec2& p, const Vec2& q) {
    const Vec2 across = q - p;
    const double border = dot(across, 0.5 * (p + q));
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double beyond_a = dot(across, a) - border, beyond_b = dot(across, b) - border;
        if (beyond_a <= 0) result.push_back(a);
        if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0))
            result.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
    }
    return result.size() < 3 ? std::vector<Vec2>() : result;
}

}  // namespace

std::vector<Vec2> voronoi_cell(std::span<const Vec2> points, std::size_t i, const Vec2& low,
                               const Vec2& high) {
    count_long_work(5 * points.size());
    const Vec2 own = points[i];
    std::vector<Vec2> cell = {low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)};
    std::vector<Neighbour> others;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (k != i) add_to_heap(others, {square(points[k] - own), k});
    for (; !others.empty() && !cell.empty(); remove_greatest(others)) {
        const auto [distance2, k] = others.front();
        if (points[k] == own) return {};
        // Stops when no corner is so far away that this point, or any after it, could be nearer to
        // it.
        double reach = 0;
        for (const Vec2& corner : cell) reach = std::max(reach, square(corner - own));
        if (distance2 > 4 * reach) break;
        count_long_work(1 + cell.size() / 4);
        cell = nearer(cell, own, points[k]);
    }
    return cell;
}

}  // namespace candelabra
