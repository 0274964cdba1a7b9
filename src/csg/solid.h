// SPDX-License-Identifier: GPL-3.0-or-later
// Queries of single objects: inside, trace, min_extent and max_extent of the language. An object is
// built at the first query and kept for the next ones.
#pragma once

#include "base/handle.h"
#include "base/surface_hit.h"
#include "csg/shape_store.h"
#include "scene/scene.h"
#include "shape/composite.h"

#include <optional>
#include <unordered_map>

namespace candelabra {

class Solids {
public:
    /// The first hit of the ray further away than 1e-4, as in POV-Ray; the direction is not 0.
    std::optional<SurfaceHit> trace(const ObjectHandle&, const Vec3& from, const Vec3& direction);

    bool inside(const ObjectHandle&, const Vec3& point);
    /// has_inside(), computed at the first query.
    bool solid(const ObjectHandle&);

    /// The object in the form for ray tests; the reference is valid as long as this.
    const Composite& composite(const ObjectHandle&);

private:
    struct Known {
        ObjectHandle object;  ///< kept, so that no address is reused
        Composite composite;
        bool solid;  ///< has an inside
    };

    const Known& known(const ObjectHandle&);

    ShapeStore shapes_;
    std::unordered_map<const Object*, Known> known_;
    const Known* last_ = nullptr;
};

/// Whether inside() can be true anywhere: false for shapes without an inside, such as triangles and
/// polygons, and for objects that have such a part.
bool has_inside(const Object&);

}  // namespace candelabra
