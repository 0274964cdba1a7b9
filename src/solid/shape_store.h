// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes made ready for rays, each once: a lathe that is declared once and placed a thousand times
// is built once. Called by whoever makes primitives of objects.
#pragma once

#include "shape/built_shape.h"

#include <unordered_map>

class ShapeStore {
public:
    /// Precondition: problem(shape) is empty.
    BuiltShape built(const Shape&);

private:
    /// By the address of what the copies share; the shape is kept so that no address comes twice.
    struct Known {
        Shape shape;
        BuiltShape built;
    };
    std::unordered_map<const void*, Known> known_;
};
