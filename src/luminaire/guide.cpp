// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/guide.h"

#include "shape/area.h"

namespace candelabra {

// Bounding boxes are built faster than a kd-tree, and take a fraction of its memory.
Guide::Guide(const Mesh& mesh, std::vector<double> luminance)
    : mesh_(build(mesh, BoundingBoxes{})),
      luminance_(std::move(luminance)),
      area_(mesh, luminance_) {}

Vec3 Guide::point(const Vec2& u) const {
    const auto [number, part] = area_.at(u.x);
    const auto [a, b, c] = face(*mesh_.mesh, number).corners;
    return sample_area(Triangle{a, b, c}, {part, u.y}).position;
}

bool Guide::met_by(const Ray& ray) const {
    Crossings met;
    crossings(mesh_, ray, met);
    for (std::size_t i = 0; i < met.size(); ++i)
        if (met[i].t > 0) return true;
    return false;
}

double Guide::density(const Vec3& from, const Vec3& direction) const {
    Crossings met;
    crossings(mesh_, Ray{from, direction}, met);
    double sum = 0;
    for (std::size_t i = 0; i < met.size(); ++i) {
        const double seen = std::abs(dot(met[i].normal, direction));
        if (!(met[i].t > 0 && seen > 0)) continue;
        const double counts = luminance_.empty() ? 1 : luminance_[met[i].part];
        sum += counts * met[i].t * met[i].t / seen;
    }
    return sum / area_.total();
}

}  // namespace candelabra
