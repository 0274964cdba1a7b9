// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/guide.h"

#include "shape/area.h"

Guide::Guide(const Mesh& mesh) : mesh_(build(mesh)), area_(mesh) {}

Vec3 Guide::point(const Vec2& u) const {
    const auto [number, part] = area_.at(u.x);
    const auto [a, b, c] = face(*mesh_.mesh, number).corners;
    return sample_area(Triangle{a, b, c}, {part, u.y}).position;
}

double Guide::density(const Vec3& from, const Vec3& direction) const {
    Crossings met;
    crossings(mesh_, Ray{from, direction}, met);
    double sum = 0;
    for (std::size_t i = 0; i < met.size(); ++i) {
        const double seen = std::abs(dot(met[i].normal, direction));
        if (met[i].t > 0 && seen > 0) sum += met[i].t * met[i].t / seen;
    }
    return sum / area_.total();
}
