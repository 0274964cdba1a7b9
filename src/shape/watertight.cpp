// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/watertight.h"

#include "base/order.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// Gives corners in the same place one number.
std::vector<int> numbers_by_place(const std::vector<Vec3>& vertices) {
    const auto place = [&](int i) {
        const Vec3& v = vertices[static_cast<std::size_t>(i)];
        return std::array{v.x, v.y, v.z};
    };
    std::vector<int> order(vertices.size()), number(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    sort_stably(order, [&](int a, int b) { return place(a) < place(b); });
    int last = -1;
    for (const int i : order) {
        if (last < 0 || place(i) != place(last)) last = i;
        number[static_cast<std::size_t>(i)] = last;
    }
    return number;
}

}  // namespace

Closure closure(const Mesh& mesh) {
    const std::vector<int> number = numbers_by_place(mesh.vertices);
    /// From the lower number to the higher one, and whether a face runs along it in this direction.
    struct Edge {
        std::pair<int, int> ends;
        bool forwards;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.faces.size());
    double volume = 0;
    for (const Face& face : mesh.faces) {
        std::array<int, 3> corner;
        for (std::size_t i = 0; i < 3; ++i) corner[i] = number[static_cast<std::size_t>(face[i])];
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = corner[i], to = corner[(i + 1) % 3];
            edges.push_back({std::minmax(from, to), from < to});
        }
        const auto at = [&](std::size_t i) {
            return mesh.vertices[static_cast<std::size_t>(face[i])] - mesh.vertices.front();
        };
        volume += dot(at(0), cross(at(0) - at(1), at(2) - at(1)));
    }
    sort_stably(edges, {}, &Edge::ends);
    bool agree = true;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        int forwards = 0;
        for (; end < edges.size() && edges[end].ends == edges[i].ends; ++end)
            forwards += edges[end].forwards ? 1 : -1;
        if ((end - i) % 2 != 0) return Closure::none;
        agree = agree && forwards == 0;
        i = end;
    }
    if (edges.empty()) return Closure::none;
    if (!agree || volume == 0) return Closure::unoriented;
    return volume > 0 ? Closure::outwards : Closure::inwards;
}

Closure turned_over(Closure mesh) {
    if (mesh == Closure::outwards) return Closure::inwards;
    return mesh == Closure::inwards ? Closure::outwards : mesh;
}

}  // namespace candelabra
