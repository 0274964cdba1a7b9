// SPDX-License-Identifier: GPL-3.0-or-later
// Queries about objects, which the binder answers. To the language an object is an opaque value.
// Compiled expressions and functions of objects use them.
#pragma once

#include "base/handle.h"
#include "base/surface_hit.h"

#include <cstdint>
#include <optional>

namespace candelabra {

class Composite;
struct Object;

class ObjectQueries {
public:
    ObjectQueries() = default;
    ObjectQueries(const ObjectQueries&) = delete;
    ObjectQueries& operator=(const ObjectQueries&) = delete;
    virtual ~ObjectQueries() = default;

    // The cost of a query is added to `work`, in the steps that Evaluator::spend() counts.
    /// The first hit of the ray. Precondition: the direction is not 0.
    virtual std::optional<SurfaceHit> first_hit(const Handle<Object>&, const Vec3& from,
                                                const Vec3& direction, std::uint64_t& work) = 0;
    /// Whether the point is inside; nothing if the object has no inside.
    virtual std::optional<bool> inside(const Handle<Object>&, const Vec3& point,
                                       std::uint64_t& work) = 0;

    /// The object in the form that rays intersect; it lives as long as this.
    virtual const Composite& composite(const Handle<Object>&) = 0;
};

}  // namespace candelabra
