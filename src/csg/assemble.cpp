// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/assemble.h"

namespace candelabra {

namespace {

template <class T>
bool solid(const T&) {
    return true;
}
bool solid(const Triangle&) { return false; }
bool solid(const SmoothTriangle&) { return false; }
bool solid(const Polygon&) { return false; }
bool solid(const BicubicPatch&) { return false; }
bool solid(const Parametric&) { return false; }
bool solid(const Mesh& mesh) { return mesh.inside_vector.value_or(Vec3(0)) != Vec3(0); }

}  // namespace

bool has_inside(const Shape& shape) {
    return visit_shape([](const auto& content) { return solid(content); }, shape);
}

Handle<Transform> combined(const Handle<Transform>& inner, const Handle<Transform>& outer) {
    if (!inner) return outer;
    if (!outer) return inner;
    return make_handle<Transform>(inner->then(*outer));
}

Composite composite_of(const Object& object, ShapeStore& shapes) {
    CompositeBuilder builder(shapes.index());
    NoVisitor nobody;
    const PartRef root = Assembler<NoVisitor>(builder, shapes, nobody).add(object, nullptr);
    return builder.finish(root);
}

}  // namespace candelabra
