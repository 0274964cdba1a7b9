// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about objects, which are values like others to the language: it holds them and knows
// nothing of them. The binder answers. Asked by programs for expressions; functions of objects ask
// in the same way.
#pragma once

#include "base/handle.h"
#include "base/vector.h"

#include <cstdint>
#include <optional>

class Composite;
struct Object;

class ObjectQueries {
public:
    struct Hit {
        Vec3 position;
        Vec3 normal;  ///< unit; not turned to where the ray comes from
    };

    ObjectQueries() = default;
    ObjectQueries(const ObjectQueries&) = delete;
    ObjectQueries& operator=(const ObjectQueries&) = delete;
    virtual ~ObjectQueries() = default;

    /// The first hit of the ray; the direction is not 0.
    virtual std::optional<Hit> trace(const Handle<Object>&, const Vec3& from,
                                     const Vec3& direction) = 0;
    /// Whether the object has an inside at all.
    virtual bool solid(const Handle<Object>&) = 0;
    /// Precondition: solid().
    virtual bool inside(const Handle<Object>&, const Vec3& point) = 0;
    /// The object as rays ask it; it lives as long as this.
    virtual const Composite& composite(const Handle<Object>&) = 0;
    /// How many objects it consists of.
    virtual std::uint64_t parts(const Object&) const = 0;
};
