// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of objects to the language's questions. Given to the evaluator by evaluate().
#pragma once

#include "interpret/object_queries.h"
#include "solid/solid.h"

class SolidQueries final : public ObjectQueries {
public:
    std::optional<Hit> trace(const ObjectHandle& object, const Vec3& from,
                             const Vec3& direction) override {
        const auto hit = solids_.trace(object, from, direction);
        return hit ? std::optional(Hit{hit->position, hit->normal}) : std::nullopt;
    }
    bool solid(const ObjectHandle& object) override { return solids_.solid(object); }
    bool inside(const ObjectHandle& object, const Vec3& point) override {
        return solids_.inside(object, point);
    }
    const Composite& composite(const ObjectHandle& object) override {
        return solids_.composite(object);
    }
    std::uint64_t parts(const Object& object) const override { return object.parts; }

private:
    Solids solids_;
};
