// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/traced_normal.h"

#include "shape/winding.h"

namespace candelabra {

namespace {

/// Factor of the outward normal.
struct Side {
    const CompositeLeaf& leaf;
    const Ray& ray;  ///< in the space of the leaf
    double t;

    template <class T>
    double operator()(const T&) const {
        return 1;
    }
    double operator()(const BuiltLathe& lathe) const { return lathe.outside_right ? 1 : -1; }
    double operator()(const BuiltPrism& prism) const {
        const double y = ray.at(t).y;
        const std::optional<bool> right = outside_right_at(prism, ray, t);
        if (!right) return std::abs(y - prism.bottom) < std::abs(y - prism.top) ? -1 : 1;
        const bool mirrored = prism.conic && y < 0;
        return *right != mirrored ? 1 : -1;
    }
    double operator()(const BuiltText& text) const {
        const auto exchanged = [](const Vec3& v) { return Vec3(v.x, v.z, v.y); };
        const Ray swept{exchanged(ray.origin), exchanged(ray.direction)};
        return outside_right_at(text.prism, swept, t).value_or(true) ? 1 : -1;
    }
    /// Shapes whose inverse is a shape of the same kind.
    double operator()(const Quadric&) const { return leaf.inverse ? -1 : 1; }
    double operator()(const JuliaFractal&) const { return leaf.inverse ? -1 : 1; }
    /// POV-Ray reorders the corners, which matters when the triangle is transformed.
    double operator()(const Triangle& triangle) const {
        if (!leaf.transform) return 1;
        const Vec3 n = triangle_normal(triangle.corner1, triangle.corner2, triangle.corner3);
        const Vec3 size = glm::abs(n);
        const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y > size.z ? 1 : 2;
        const bool other_order = longest == 1 ? n.y < 0 : n[longest] > 0;
        return other_order != (leaf.transform->determinant() < 0) ? -1 : 1;
    }
};

}  // namespace

Vec3 traced_normal(const CompositeLeaf& leaf, const Ray& ray, const Composite::Meeting& met) {
    const Ray local = leaf.transform ? leaf.transform->inverse_ray(ray) : ray;
    return visit_shape(Side{leaf, local, met.t}, leaf.shape) * met.normal;
}

}  // namespace candelabra
