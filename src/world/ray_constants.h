// SPDX-License-Identifier: GPL-3.0-or-later
// A ray of the world, with data for testing many primitives of a kind. The data is computed on the
// first use: most rays test few kinds, and many none at all.
#pragma once

#include "shape/slabs.h"
#include "shape/triangle.h"

#include <optional>

namespace candelabra {

class RayConstants {
public:
    explicit RayConstants(const Ray& ray) : ray_(ray) {}
    explicit RayConstants(Ray&&) = delete;

    const Ray& ray() const { return ray_; }
    const Slabs& slabs() {
        if (!slabs_) slabs_.emplace(ray_);
        return *slabs_;
    }
    const ShearedRay& sheared() {
        if (!sheared_) sheared_.emplace(ray_);
        return *sheared_;
    }

private:
    const Ray& ray_;
    std::optional<Slabs> slabs_;
    std::optional<ShearedRay> sheared_;
};

}  // namespace candelabra
