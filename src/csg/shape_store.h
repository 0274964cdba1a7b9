// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes built for rays, each once: a lathe that is declared once and placed a thousand times is
// built once. Called by the code that makes primitives of objects.
#pragma once

#include "shape/built_shape.h"

#include <map>
#include <unordered_map>

namespace candelabra {

class ShapeStore {
public:
    ShapeStore() = default;
    /// `index` configures the indices of the parts of shapes.
    explicit ShapeStore(const RayIndex& index) : index_(index) {}

    const RayIndex& index() const { return index_; }

    /// Precondition: problem(shape) is empty.
    BuiltShape built(const Shape&);
    /// Builds the shape for a place; null: identity. Height fields and patches depend on their
    /// place.
    BuiltShape built(const Shape&, const Handle<Transform>& place);

private:
    /// Builds a patch that is flat enough at its place, and any other shape as it is.
    BuiltShape divided(const Shape&, const Transform& place);

    /// Keyed by the address of the content that copies share; the shape is kept so that no address
    /// is reused.
    struct Known {
        Shape shape;
        BuiltShape built;
    };
    RayIndex index_;
    std::unordered_map<const void*, Known> known_;
    struct Placed {
        Handle<Transform> place;
        BuiltShape built;
    };
    std::map<std::pair<const void*, const Transform*>, Placed> placed_;
    /// Keyed by content and scale.
    std::map<std::pair<const void*, double>, Known> divided_;
};

}  // namespace candelabra
