// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes made ready for rays, each once: a lathe that is declared once and placed a thousand times
// is built once. Called by whoever makes primitives of objects.
#pragma once

#include "shape/built_shape.h"

#include <map>
#include <unordered_map>

namespace candelabra {

class ShapeStore {
public:
    ShapeStore() = default;
    /// Parts of shapes are found by the index.
    explicit ShapeStore(const RayIndex& index) : index_(index) {}

    const RayIndex& index() const { return index_; }

    /// Precondition: problem(shape) is empty.
    BuiltShape built(const Shape&);
    /// For a place; null: none. Landscapes and patches are made for the place where they are.
    BuiltShape built(const Shape&, const Handle<Transform>& place);

private:
    /// By the address of what the copies share; the shape is kept so that no address comes twice.
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
};

}  // namespace candelabra
