// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/face_normal.h"

namespace candelabra {

namespace {

struct FaceNormal {
    std::uint32_t part;

    template <class T>
    Vec3 operator()(const T&) const {
        return Vec3(0);
    }
    Vec3 operator()(const SmoothTriangle& t) const {
        return outer_normal({t.corner1, t.corner2, t.corner3},
                            {unit(t.normal1), unit(t.normal2), unit(t.normal3)});
    }
    Vec3 operator()(const BuiltMesh& built) const {
        const MeshTriangle met = face(*built.mesh, part);
        return outer_normal(met.corners, met.normals);
    }
    Vec3 operator()(const BuiltBicubicPatch& patch) const {
        return outer_normal(patch.facets[part].corners, patch.facets[part].normals);
    }
};

}  // namespace

Vec3 face_normal(const BuiltShape& shape, std::uint32_t part) {
    return visit_shape(FaceNormal{part}, shape);
}

Vec3 surface_normal(const CompositeLeaf& leaf, const Composite::Meeting& met) {
    const Vec3 face = face_normal(leaf.shape, met.part);
    const Vec3 there = unit(leaf.transform ? leaf.transform->normal(face) : face);
    if (there == Vec3(0)) return unit(met.normal);
    return leaf.inverse != leaf.turned ? -there : there;
}

}  // namespace candelabra
