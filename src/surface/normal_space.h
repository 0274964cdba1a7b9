// SPDX-License-Identifier: GPL-3.0-or-later
// How normals come into the space of a pattern and out of it: through its transformations, not its
// warps. Used by bumps and by textures with a pattern.
#pragma once

#include "pattern/warp.h"

/// In and out of the space of a pattern: through all transformations of its list, not the warps.
class NormalSpace {
public:
    NormalSpace(const std::vector<WarpStep>& steps, const Transform& outside)
        : steps_(steps), outside_(outside) {}

    Vec3 enter(Vec3 normal) const {
        normal = back(outside_, normal);
        for (std::size_t i = steps_.size(); i-- > 0;)
            if (const auto* step = std::get_if<Transform>(&steps_[i])) normal = back(*step, normal);
        return normal;
    }
    Vec3 leave(Vec3 normal) const {
        for (const WarpStep& any : steps_)
            if (const auto* step = std::get_if<Transform>(&any)) normal = step->normal(normal);
        return outside_.normal(normal);
    }

private:
    static Vec3 back(const Transform& transform, const Vec3& n) {
        const auto& rows = transform.forward().rows;
        return {dot(n, rows[0]), dot(n, rows[1]), dot(n, rows[2])};
    }

    const std::vector<WarpStep>& steps_;
    const Transform& outside_;
};
