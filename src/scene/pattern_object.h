// SPDX-License-Identifier: GPL-3.0-or-later
// The object of `pigment { object { ... } }`, which patterns hold without its type.
#pragma once

#include "scene/scene.h"
#include "shape/composite.h"

namespace candelabra {

/// What PointFunction::data of an ObjectPattern points to.
struct PatternObject {
    Composite solid;
    ObjectHandle object;  ///< for the dump
};

}  // namespace candelabra
