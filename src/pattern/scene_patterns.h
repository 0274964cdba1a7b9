// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns whose values come from parts of a scene that are defined after the patterns: the grey of
// a pigment. The evaluator ties the two together.
#pragma once

#include "pattern/modifiers.h"
#include "pattern/nesting.h"

#include <memory>

namespace candelabra {

/// A number for each point, by code that knows what the data is.
struct PointFunction {
    std::shared_ptr<const void> data;
    double (*code)(const void* data, const Vec3& point, const PatternScene&) = nullptr;

    double operator()(const Vec3& point, const PatternScene& scene) const {
        return code ? code(data.get(), point, scene) : 0;
    }
};

struct PigmentGrey {
    PointFunction grey;
    Nesting nesting;  ///< of the pigment

    static const ItemInfo vocabulary;
};

inline double evaluate(const PigmentGrey& kind, const PatternPoint& at) {
    return kind.grey(at.position, at.scene);
}

/// 1 inside of an object, 0 outside.
struct ObjectPattern {
    static constexpr int choices = 2;
    PointFunction inside;

    static const ItemInfo vocabulary;
};

inline double evaluate(const ObjectPattern& kind, const PatternPoint& at) {
    return kind.inside(at.position, at.scene);
}

/// Has no value: the entries of its map are all mixed by their weights.
struct Average {
    static const ItemInfo vocabulary;
};

inline double evaluate(const Average&, const Vec3&) { return 0; }

}  // namespace candelabra
