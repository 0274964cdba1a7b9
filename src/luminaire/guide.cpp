// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/guide.h"

#include "shape/triangle.h"

#include <algorithm>

Guide::Guide(const Mesh& mesh) : mesh_(build(mesh)) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = face(mesh, i).corners;
        areas_.push_back(sum += 0.5 * length(cross(b - a, c - a)));
    }
}

Vec3 Guide::point(const Vec2& u) const {
    const double wanted = u.x * areas_.back();
    const auto found = std::upper_bound(areas_.begin(), areas_.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(found - areas_.begin());
    const double before = i == 0 ? 0 : areas_[i - 1];
    const double rest = std::clamp((wanted - before) / (areas_[i] - before), 0.0, 1.0);
    const auto [a, b, c] = face(*mesh_.mesh, i).corners;
    const double s = std::sqrt(rest);
    return (1 - s) * a + s * (1 - u.y) * b + s * u.y * c;
}

double Guide::density(const Vec3& from, const Vec3& direction) const {
    Crossings met;
    crossings(mesh_, Ray{from, direction}, met);
    double sum = 0;
    for (std::size_t i = 0; i < met.size(); ++i) {
        const double seen = std::abs(dot(met[i].normal, direction));
        if (met[i].t > 0 && seen > 0) sum += met[i].t * met[i].t / seen;
    }
    return sum / areas_.back();
}
