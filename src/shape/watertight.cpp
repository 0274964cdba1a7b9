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

bool is_watertight(const Mesh& mesh) {
    const std::vector<int> number = numbers_by_place(mesh.vertices);
    std::vector<std::pair<int, int>> edges;
    edges.reserve(3 * mesh.faces.size());
    for (const Face& face : mesh.faces) {
        std::array<int, 3> corner;
        for (std::size_t i = 0; i < 3; ++i) corner[i] = number[static_cast<std::size_t>(face[i])];
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
        for (std::size_t i = 0; i < 3; ++i)
            edges.push_back(std::minmax(corner[i], corner[(i + 1) % 3]));
    }
    std::ranges::sort(edges);
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        while (end < edges.size() && edges[end] == edges[i]) ++end;
        if ((end - i) % 2 != 0) return false;
        i = end;
    }
    return !edges.empty();
}

}  // namespace candelabra
