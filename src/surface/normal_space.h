// SPDX-License-Identifier: GPL-3.0-or-later
// Transforms normals into the space of a pattern and out of it: by its transformations, but not its
// warps. Used by bumps and by textures with a pattern.
#pragma once

#include "pattern/modifiers.h"
#include "pattern/warp.h"

namespace candelabra {

class NormalSpace {
public:
    /// `frame` is the outermost transform; null: identity.
    NormalSpace(const std::vector<WarpStep>& steps, const Transform& outside,
                const Transform* frame)
        : steps_(steps), outside_(outside), frame_(frame) {}

    Vec3 enter(Vec3 normal) const {
        if (frame_) normal = frame_->inverse().normal(normal);
        normal = outside_.inverse().normal(normal);
        for (std::size_t i = steps_.size(); i-- > 0;)
            if (const auto* step = std::get_if<Transform>(&steps_[i]))
                normal = step->inverse().normal(normal);
        return normal;
    }
    Vec3 leave(Vec3 normal) const {
        for (const WarpStep& any : steps_)
            if (const auto* step = std::get_if<Transform>(&any)) normal = step->normal(normal);
        normal = outside_.normal(normal);
        return frame_ ? frame_->normal(normal) : normal;
    }

    /// The gradients of the coordinates of a place behind the transformations, in the space around
    /// the pattern. `uv`: the pattern lies in u and v.
    SurfaceAxes placed(SurfaceAxes axes, bool uv) const {
        axes.by_uv |= uv;
        if (!axes.by_uv) return axes;
        const Vec3 first = uv ? axes.u : axes.x, second = uv ? axes.v : axes.y;
        const Vec3 right = inwards(Vec3(1, 0, 0)), up = inwards(Vec3(0, 1, 0));
        axes.x = right.x * first + up.x * second;
        axes.y = right.y * first + up.y * second;
        return axes;
    }
    /// The same in the space of the pattern, for what is in it.
    SurfaceAxes enter(const SurfaceAxes& around, bool uv) const {
        SurfaceAxes axes = placed(around, uv);
        axes.u = enter(axes.u);
        axes.v = enter(axes.v);
        if (!axes.by_uv) return axes;
        axes.x = enter(axes.x);
        axes.y = enter(axes.y);
        return axes;
    }

private:
    Vec3 inwards(Vec3 direction) const {
        direction = outside_.inverse().direction(direction);
        for (std::size_t i = steps_.size(); i-- > 0;)
            if (const auto* step = std::get_if<Transform>(&steps_[i]))
                direction = step->inverse().direction(direction);
        return direction;
    }

    const std::vector<WarpStep>& steps_;
    const Transform& outside_;
    const Transform* frame_;
};

}  // namespace candelabra
