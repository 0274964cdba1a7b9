// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about objects, which are values like others to the language: it holds them and knows
// nothing of them. The binder answers. Asked by programs for expressions; functions of objects ask
// in the same way.
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

    // Their cost is added to `work`, in the steps that Evaluator::spend() counts.
    /// The first hit of the ray; the direction is not 0.
    virtual std::optional<SurfaceHit> first_hit(const Handle<Object>&, const Vec3& from,
                                                const Vec3& direction, std::uint64_t& work) = 0;
    /// Whether the point is inside; nothing when the object has no inside at all.
    virtual std::optional<bool> inside(const Handle<Object>&, const Vec3& point,
                                       std::uint64_t& work) = 0;

    /// The object as rays ask it; it lives as long as this.
    virtual const Composite& composite(const Handle<Object>&) = 0;
};

}  // namespace candelabra
