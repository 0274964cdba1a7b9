// SPDX-License-Identifier: GPL-3.0-or-later
// Answers the language's queries about objects. Given to the evaluator by evaluate().
#pragma once

#include "csg/solid.h"
#include "interpret/object_queries.h"

namespace candelabra {

class SolidQueries final : public ObjectQueries {
public:
    std::optional<SurfaceHit> first_hit(const ObjectHandle& object, const Vec3& from,
                                        const Vec3& direction, std::uint64_t& work) override {
        work += asking;
        return solids_.trace(object, from, direction);
    }
    std::optional<bool> inside(const ObjectHandle& object, const Vec3& point,
                               std::uint64_t& work) override {
        if (!solids_.solid(object)) return std::nullopt;
        work += asking;
        return solids_.inside(object, point);
    }
    const Composite& composite(const ObjectHandle& object) override {
        return solids_.composite(object);
    }

private:
    /// Work of one query beside that of its parts, which count it as they are visited.
    static constexpr std::uint64_t asking = 300;

    Solids solids_;
};

}  // namespace candelabra
