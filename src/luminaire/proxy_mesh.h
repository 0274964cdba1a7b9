// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles near a glowing surface without a formula, at which rays are aimed to find its points.
// The rays find the exact points on the surface, so the proxy mesh is approximate, and its users
// also aim elsewhere at times. Used by the composite emitter.
#pragma once

#include "base/handle.h"
#include "base/transform.h"
#include "shape/mesh_area.h"

namespace candelabra {

class ProxyMesh {
public:
    /// `luminance` has one value for each face if the radiance varies, and is empty if all faces
    /// are equally bright. Precondition: some face has an area, and if there are luminances, one
    /// such face has a luminance above 0.
    explicit ProxyMesh(const Mesh&, std::vector<double> luminance = {});
    /// The same triangles, which both share, in another place. Precondition: the other proxy mesh
    /// was not placed.
    ProxyMesh(const ProxyMesh&, Handle<Transform> place);

    /// Returns the point for u, uniform in [0, 1)^2. Its density is uniform over the triangles'
    /// area before they were placed, times their luminance.
    Vec3 point(const Vec2& u) const;

    /// Whether the ray meets any triangle.
    bool met_by(const Ray&) const;

    /// Density per steradian, as seen from a position, with which points lie in this unit
    /// direction.
    double density(const Vec3& from, const Vec3& direction) const;

private:
    struct Triangles {
        BuiltMesh mesh;
        std::vector<double> luminance;
        MeshArea area;
    };

    Ray own_ray(const Vec3& from, const Vec3& direction) const;

    Handle<Triangles> triangles_;
    Handle<Transform> place_ = nullptr;  ///< null: identity
};

}  // namespace candelabra
