// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles near a glowing surface that has no formula: where its points are looked for. The
// surface itself says where they are; so the guide need not be exact, and whoever uses it also
// looks elsewhere now and then. Called by the composite emitter.
#pragma once

#include "shape/mesh_area.h"

namespace candelabra {

class Guide {
public:
    /// `luminance`: of each face, for luminaires whose glow varies; none: they are all the same.
    /// Precondition: some face has an area, and if there are luminances, one that is above 0.
    explicit Guide(const Mesh&, std::vector<double> luminance = {});

    /// The point for u, which is uniform in [0, 1)^2: uniform over the area of the triangles, times
    /// their luminance.
    Vec3 point(const Vec2& u) const;

    /// Whether some triangle is on the line, ahead.
    bool met_by(const Ray&) const;

    /// Probability per steradian with which the points lie in this unit direction from there.
    double density(const Vec3& from, const Vec3& direction) const;

private:
    BuiltMesh mesh_;
    std::vector<double> luminance_;
    MeshArea area_;
};

}  // namespace candelabra
