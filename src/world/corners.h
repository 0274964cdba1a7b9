// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of triangles that are placed in a world. Used by flatten() and for hits.
#pragma once

#include "shape/face_normal.h"
#include "shape/mesh.h"
#include "shape/triangle.h"
#include "world/world.h"

#include <array>
#include <utility>

namespace candelabra {

inline TrianglePrimitive placed(const TrianglePrimitive& t, const Transform* transform) {
    return transform ? TrianglePrimitive{transform->point(t.corner1), transform->point(t.corner2),
                                         transform->point(t.corner3)}
                     : t;
}

inline CornerNormals placed(const CornerNormals& n, const Transform* transform) {
    return transform ? CornerNormals{transform->normal(n.normal1), transform->normal(n.normal2),
                                     transform->normal(n.normal3)}
                     : n;
}

inline CornerNormals units(const CornerNormals& n) {
    return {unit(n.normal1), unit(n.normal2), unit(n.normal3)};
}

/// A single smooth triangle.
struct SmoothCorners {
    TrianglePrimitive corners;
    CornerNormals normals;

    void put_outer_side_first() {
        const auto& [a, b, c] = corners;
        const Vec3 outer =
            outer_normal({a, b, c}, {normals.normal1, normals.normal2, normals.normal3});
        if (dot(triangle_normal(a, b, c), outer) >= 0) return;
        std::swap(corners.corner2, corners.corner3);
        std::swap(normals.normal2, normals.normal3);
    }
};

inline SmoothCorners placed(const SmoothTriangle& s, const Transform* transform) {
    return {placed(TrianglePrimitive{s.corner1, s.corner2, s.corner3}, transform),
            units(placed(CornerNormals{s.normal1, s.normal2, s.normal3}, transform))};
}

/// As in POV-Ray, the outer side of a single transformed triangle is that towards -x, +y or -z,
/// along the greatest component of its normal.
inline TrianglePrimitive outer_side_first(const TrianglePrimitive& t) {
    const Vec3 normal = triangle_normal(t.corner1, t.corner2, t.corner3);
    const Vec3 size = glm::abs(normal);
    const double outwards = size.x >= size.y && size.x >= size.z ? -normal.x
                            : size.y >= size.z                   ? normal.y
                                                                 : -normal.z;
    return outwards < 0 ? TrianglePrimitive{t.corner1, t.corner3, t.corner2} : t;
}

/// A face of a mesh, with all attributes of its corners.
struct MeshFace {
    MeshTriangle shape;
    std::array<Vec2, 3> uvs;
    Face looks;

    /// Whether the winding has the normals on its inner side.
    bool is_inside_out() const {
        const auto& [a, b, c] = shape.corners;
        return shape.smooth &&
               dot(triangle_normal(a, b, c), outer_normal(shape.corners, shape.normals)) < 0;
    }

    /// Exchanges the two sides.
    void turn_over() {
        std::swap(shape.corners[1], shape.corners[2]);
        std::swap(shape.normals[1], shape.normals[2]);
        std::swap(uvs[1], uvs[2]);
        std::swap(looks[1], looks[2]);
    }
};

}  // namespace candelabra
