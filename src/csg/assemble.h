// SPDX-License-Identifier: GPL-3.0-or-later
// Converts an object of the scene, with all objects in it, to the leaves and nodes of a composite.
// Called by the world for objects that cannot be split, and by the functions of the language for
// any object. A visitor learns which object each leaf belongs to.
#pragma once

#include "csg/shape_store.h"
#include "scene/scene.h"
#include "shape/composite.h"

namespace candelabra {

/// The map `inner` followed by `outer`; null is the identity.
Handle<Transform> combined(const Handle<Transform>& inner, const Handle<Transform>& outer);

/// Whether points can be inside the shape: surfaces without an inside have none to invert.
bool has_inside(const Shape&);

/// For callers that do not track the leaves.
struct NoVisitor {
    void enter(const Object&) {}
    void leave() {}
    void leaf(const Object&) {}
};

template <class Visitor>
class Assembler {
public:
    /// The visitor is called for each object when it is entered and left, and for each shape in the
    /// order of the leaves' numbers.
    Assembler(CompositeBuilder& builder, ShapeStore& shapes, Visitor& visitor)
        : builder_(builder), shapes_(shapes), visitor_(visitor) {}

    /// Adds the object under a map; `inverse` swaps inside and outside once more.
    PartRef add(const Object& object, const Handle<Transform>& outer, bool inverse = false) {
        visitor_.enter(object);
        const Handle<Transform> transform = combined(object.transform, outer);
        const bool swapped = object.inverse != inverse;
        PartRef part = content(object, transform, swapped);
        if (object.clipping) part = clipped(part, *object.clipping, outer);
        visitor_.leave();
        return part;
    }

private:
    PartRef content(const Object& object, const Handle<Transform>& transform, bool inverse) {
        if (const auto* parts = std::get_if<Union>(&object.form))
            return group(*parts, transform, inverse);
        const auto leaf = [&](const BuiltShape& shape, bool swapped, bool turned = false) {
            visitor_.leaf(object);
            return builder_.add({shape, transform, swapped, turned});
        };
        // As in POV-Ray, inversion does not give shapes without an inside one; but it turns a mesh.
        if (const auto* shape = std::get_if<Shape>(&object.form)) {
            const bool swapped = inverse && has_inside(*shape);
            const bool mesh = std::holds_alternative<Shared<Mesh>>(*shape);
            return leaf(shapes_.built(*shape, transform), swapped, mesh && inverse && !swapped);
        }
        std::vector<PartRef> parts;
        for (const Sphere& sphere : std::get<SphereRow>(object.form).spheres)
            parts.push_back(leaf(sphere, inverse));
        return builder_.add(inverse ? Combination::common : Combination::together,
                            std::move(parts));
    }

    /// Whether the object is no part of a solid: light sources and, where it makes no difference,
    /// objects that the scene left out because they are empty.
    static bool is_nothing(const Object& object, bool cuts) {
        const auto* group = std::get_if<Union>(&object.form);
        return group && group->children.empty() && (!cuts || !group->lights.empty());
    }

    /// By De Morgan's rule, the inverse is the dual combination of the inverse parts. The inverse
    /// of an intersection is a merge: no part has surface within another.
    PartRef group(const Union& group, const Handle<Transform>& transform, bool inverse) {
        const bool cuts = group.csg == Csg::intersection || group.csg == Csg::difference;
        const Combination how = cuts != inverse                   ? Combination::common
                                : cuts || group.csg == Csg::merge ? Combination::merged
                                                                  : Combination::together;
        std::vector<PartRef> parts;
        for (const ObjectHandle& child : group.children) {
            if (is_nothing(*child, cuts)) continue;
            const bool taken_away = group.csg == Csg::difference && !parts.empty();
            parts.push_back(add(*child, transform, inverse != taken_away));
        }
        return builder_.add(how, std::move(parts));
    }

    PartRef clipped(PartRef part, const Clipping& clipping, const Handle<Transform>& outer) {
        std::vector<PartRef> parts = {part};
        for (const ObjectHandle& each : clipping.clips) {
            parts.push_back(add(*each, outer));
            parts.back().clips = true;
        }
        part = builder_.add(Combination::common, std::move(parts));
        if (clipping.bounds.empty()) return part;
        CompositeBuilder around(shapes_.index());
        NoVisitor nobody;
        Assembler<NoVisitor> assembler(around, shapes_, nobody);
        std::vector<PartRef> bounds;
        for (const ObjectHandle& each : clipping.bounds)
            bounds.push_back(assembler.add(*each, outer));
        const PartRef root = around.add(Combination::common, std::move(bounds));
        return builder_.add(Combination::together, {part},
                            make_handle<Composite>(around.finish(root)));
    }

    CompositeBuilder& builder_;
    ShapeStore& shapes_;
    Visitor& visitor_;
};

/// A single object as one solid.
Composite composite_of(const Object&, ShapeStore&);

}  // namespace candelabra
