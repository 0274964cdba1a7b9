// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/proxy_mesh.h"

#include "shape/area.h"

#include <cmath>
#include <utility>

namespace candelabra {

// Bounding boxes are built faster than a kd-tree, and take a fraction of its memory.
ProxyMesh::ProxyMesh(const Mesh& mesh, std::vector<double> luminance) {
    MeshArea area(mesh, luminance);
    triangles_ = make_handle<Triangles>(
        Triangles{build(mesh, BoundingBoxes{}), std::move(luminance), std::move(area)});
}

ProxyMesh::ProxyMesh(const ProxyMesh& other, Handle<Transform> place)
    : triangles_(other.triangles_), place_(std::move(place)) {}

/// The ray in the space of the triangles.
Ray ProxyMesh::own_ray(const Vec3& from, const Vec3& direction) const {
    const Ray ray{from, direction};
    return place_ ? place_->inverse_ray(ray) : ray;
}

Vec3 ProxyMesh::point(const Vec2& u) const {
    const auto [number, part] = triangles_->area.at(u.x);
    const auto [a, b, c] = face(*triangles_->mesh.mesh, number).corners;
    const Vec3 drawn = sample_area(Triangle{a, b, c}, {part, u.y}).position;
    return place_ ? place_->point(drawn) : drawn;
}

bool ProxyMesh::met_by(const Ray& ray) const {
    Crossings met;
    crossings(triangles_->mesh, own_ray(ray.origin, ray.direction), met);
    for (std::size_t i = 0; i < met.size(); ++i)
        if (met[i].t > 0) return true;
    return false;
}

double ProxyMesh::density(const Vec3& from, const Vec3& direction) const {
    const Ray ray = own_ray(from, direction);
    Crossings met;
    crossings(triangles_->mesh, ray, met);
    double sum = 0;
    for (std::size_t i = 0; i < met.size(); ++i) {
        const double seen = std::abs(dot(met[i].normal, ray.direction));
        if (!(met[i].t > 0 && seen > 0)) continue;
        const double counts =
            triangles_->luminance.empty() ? 1 : triangles_->luminance[met[i].part];
        sum += counts * met[i].t * met[i].t / seen;
    }
    // A volume of the triangles' space, as seen along the ray, is one of the world divided by the
    // determinant; t is the distance in the world.
    const double per_volume = place_ ? std::abs(place_->determinant()) : 1;
    return sum / (per_volume * triangles_->area.total());
}

}  // namespace candelabra
