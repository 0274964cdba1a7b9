// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a glowing primitive in pieces, for integrals over it: its area and the light that
// leaves it. Used for lamps whose flux is stated.
#pragma once

#include "base/function_ref.h"
#include "world/world.h"

#include <vector>

namespace candelabra {

/// A piece of a surface.
struct SurfacePiece {
    Vec3 position;
    Vec3 normal;  ///< unit, outwards
    double area;
    bool turned = false;  ///< whether the outer side of its texture is on the inside
};

struct LitSurface {
    std::vector<SurfacePiece> pieces;
    double area = 0;    ///< of one side; more exact than the sum of the pieces where it can be
    bool open = false;  ///< whether the inner side shines outwards as well
    bool round = false;  ///< whether it is alike from all sides: its pieces do not tell its normals
};

struct SurfaceUse {
    bool places = false;   ///< the light differs from place to place
    bool normals = false;  ///< the normals of the pieces matter
    bool sealed = false;   ///< a triangle is a face of a closed mesh
};

/// Takes the surface apart. Areas are right within 0.05 %; those of spheres, boxes, discs,
/// cylinders, cones, triangles and meshes are exact if they are not stretched. There are only as
/// many pieces as the use needs, at least one unless there is no surface.
LitSurface lit_surface(const World&, PrimitiveIndex, const SurfaceUse&);

}  // namespace candelabra
