// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns whose values come from scene elements that are defined after the patterns, such as the
// brightness of a pigment. The evaluator connects the two.
#pragma once

#include "pattern/modifiers.h"
#include "pattern/nesting.h"

#include <memory>

namespace candelabra {

/// Computes a number for each point by code that knows the type of the data.
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

/// 1 inside an object, 0 outside.
struct ObjectPattern {
    static constexpr int choices = 2;
    PointFunction inside;

    static const ItemInfo vocabulary;
};

inline double evaluate(const ObjectPattern& kind, const PatternPoint& at) {
    return kind.inside(at.position, at.scene);
}

/// All entries of the map are mixed by their weights; the value is not used.
struct Average {
    static const ItemInfo vocabulary;
};

inline double evaluate(const Average&, const Vec3&) { return 0; }

}  // namespace candelabra
