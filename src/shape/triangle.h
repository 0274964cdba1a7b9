// SPDX-License-Identifier: GPL-3.0-or-later
// Flat and smooth triangles. They have no inside.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A flat triangle.
struct Triangle {
    Vec3 corner1 = Vec3(0);
    Vec3 corner2 = Vec3(1, 0, 0);
    Vec3 corner3 = Vec3(0, 1, 0);

    static const ItemInfo vocabulary;
};

/// A triangle shaded as if it were curved: its normal is interpolated between those of the corners.
struct SmoothTriangle {
    Vec3 corner1 = Vec3(0), normal1 = Vec3(0, 0, 1);
    Vec3 corner2 = Vec3(1, 0, 0), normal2 = Vec3(0, 0, 1);
    Vec3 corner3 = Vec3(0, 1, 0), normal3 = Vec3(0, 0, 1);

    static const ItemInfo vocabulary;
};

Box bounds(const Triangle&);
void crossings(const Triangle&, const Ray&, Crossings&);
bool inside(const Triangle&, const Vec3&);
/// Bounds of the part of the triangle in the cell; empty when it does not pass through it.
Box clipped_bounds(const Triangle&, const Box& cell);

Box bounds(const SmoothTriangle&);
void crossings(const SmoothTriangle&, const Ray&, Crossings&);
bool inside(const SmoothTriangle&, const Vec3&);

/// Error that the ranges of single fields do not exclude (a normal of length 0), as a sentence;
/// empty when there is none.
std::string problem(const SmoothTriangle&);
/// See shape.h.
std::string vanishes(const Triangle&);
std::string vanishes(const SmoothTriangle&);

/// Unit normal of a flat triangle, on the same side as in POV-Ray 3.7; 0 when the corners are
/// collinear.
inline Vec3 triangle_normal(const Vec3& corner1, const Vec3& corner2, const Vec3& corner3) {
    return unit(cross(corner1 - corner2, corner3 - corner2));
}

/// Barycentric weights of a point of the triangle's plane; they add up to 1.
Vec3 corner_weights(const std::array<Vec3, 3>& corners, const Vec3& point);

/// Hit of a ray in a triangle's plane: parameter and barycentric weights of corners 2 and 3.
struct TriangleHit {
    double t, weight2, weight3;
};

/// Which of two triangles that share an edge a ray hits when it runs exactly through the edge.
enum class Edges {
    both,  ///< both: nothing is lost, even at the rim of a surface
    one,   ///< exactly one, so that crossings of a closed surface can be counted
};

/// A ray prepared for tests against many triangles. Watertight: triangles that share an edge leave
/// no gap between them (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2013),
/// because the sign of an edge is computed from the same two products in both of them.
class ShearedRay {
public:
    explicit ShearedRay(const Ray& ray, Edges edges = Edges::both) : ray_(ray), edges_(edges) {
        const Vec3 size = glm::abs(ray.direction);
        z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        x_ = (z_ + 1) % 3;
        y_ = (x_ + 1) % 3;
        const double along = ray.direction[z_];
        shear_ = Vec2(ray.direction[x_], ray.direction[y_]) / along;
        inverse_ = Vec3(1) / ray.direction;
        length2_ = dot(ray.direction, ray.direction);
    }

    /// Returns the hit in the range, or t = range.max. Triangles seen edge-on, or without area, are
    /// not hit.
    TriangleHit meet(const Vec3& corner1, const Vec3& corner2, const Vec3& corner3,
                     const Interval& range) const {
        const TriangleHit miss{range.max, 0, 0};
        const Vec3 &o = ray_.origin, a = corner1 - o, b = corner2 - o, c = corner3 - o;
        const Vec2 pa = project(a), pb = project(b), pc = project(c);
        const double u = edge(pb, pc), v = edge(pc, pa), w = edge(pa, pb);
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return miss;
        if (edges_ == Edges::one && (u == 0 || v == 0 || w == 0)) {
            const int side = exact_side(pb, pc);
            if (side != exact_side(pc, pa) || side != exact_side(pa, pb)) return miss;
        }
        const Vec3 normal = cross(corner1 - corner2, corner3 - corner2);
        const double sum = u + v + w, approach = dot(normal, ray_.direction);
        if (sum == 0 || approach == 0) return miss;
        // Computed from the plane, because the weights of slivers have few digits. Where the
        // triangle is seen edge-on, its plane is almost parallel to the ray, so t is clamped to the
        // bounds.
        double t = dot(normal, b) / approach;
        if (approach * approach < edge_on2 * dot(normal, normal) * length2_) {
            const Interval part = within(join(join(Box{corner1, corner1}, corner2), corner3));
            if (part.min <= part.max) t = std::clamp(t, part.min, part.max);
        }
        return range.contains(t) ? TriangleHit{t, v / sum, w / sum} : miss;
    }

private:
    /// Squared sine of the angle between ray and plane above which t has nearly all digits.
    static constexpr double edge_on2 = 0.01;

    /// Same as clip() of the whole line.
    Interval within(const Box& box) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Interval part{-infinity, infinity};
        for (int axis = 0; axis < 3; ++axis) {
            const bool backward = std::signbit(inverse_[axis]);
            const Vec3 &first = backward ? box.high : box.low,
                       &last = backward ? box.low : box.high;
            const double near = (first[axis] - ray_.origin[axis]) * inverse_[axis];
            const double far = (last[axis] - ray_.origin[axis]) * inverse_[axis];
            part.min = near > part.min ? near : part.min;
            part.max = far < part.max ? far : part.max;
        }
        return part;
    }
    /// Projects along the ray onto a plane, with the ray at its origin.
    Vec2 project(const Vec3& p) const {
        return {p[x_] - shear_.x * p[z_], p[y_] - shear_.y * p[z_]};
    }
    /// Positive when the ray is on the right of the edge from p to q, and exactly the negative for
    /// the edge from q to p.
    static double edge(const Vec2& p, const Vec2& q) { return q.x * p.y - q.y * p.x; }
    /// The sign of edge() without rounding; a ray exactly on the edge is treated as slightly to one
    /// side, consistently for all edges.
    static int exact_side(const Vec2& p, const Vec2& q);

    Ray ray_;
    Vec2 shear_;
    Vec3 inverse_;    ///< of the direction
    double length2_;  ///< of the direction, squared
    int x_, y_, z_;
    Edges edges_;
};

/// Tests a ray against a single triangle.
TriangleHit first_crossing(const Vec3& corner1, const Vec3& corner2, const Vec3& corner3,
                           const Ray&, const Interval& range);

}  // namespace candelabra
