// SPDX-License-Identifier: GPL-3.0-or-later
// Transforms normals into the space of a pattern and out of it: by its transformations, but not its
// warps. Used by bumps and by textures with a pattern.
#pragma once

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

private:
    const std::vector<WarpStep>& steps_;
    const Transform& outside_;
    const Transform* frame_;
};

}  // namespace candelabra
