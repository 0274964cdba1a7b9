// SPDX-License-Identifier: GPL-3.0-or-later
// Light under surfaces that let it in: the words for it, and the dipole approximation of how it
// spreads (Jensen, Marschner, Levoy, Hanrahan, "A Practical Model for Subsurface Light Transport",
// 2001), with POV-Ray 3.7's way from the words to the model. Called by the renderer.
#pragma once

#include "vocabulary/item_info.h"

namespace candelabra {

/// In a finish.
struct Subsurface {
    Vec3 translucency = Vec3(0);  ///< mean way between two scatterings in millimetres; 0: opaque

    static const ItemInfo vocabulary;
    friend bool operator==(const Subsurface&, const Subsurface&) = default;
};

/// In global_settings.
struct SubsurfaceSettings {
    int samples = 50;         ///< points where light may enter, for each point that is seen
    int single_samples = 50;  ///< places below it where light may be scattered once
    bool on = false;          ///< the block is there; finishes count only then

    static const ItemInfo vocabulary;
};

/// The inside of a solid that scatters light, by channel, in the scene's units.
class Dipole {
public:
    /// `albedo`: the share of light that comes out again altogether, without what the surface
    /// reflects, 0..1; `free_path`: between two scatterings, above 0; `ior`: of the inside over
    /// that of the outside.
    Dipole(const Vec3& albedo, const Vec3& free_path, double ior);

    /// The flux that comes out per area at a distance from where flux of 1 goes in.
    Vec3 spread(double distance2) const;

    /// Of the source below the surface, 0, and of the one above it, 1: how far away they are.
    const Vec3& heights(int source) const { return source == 0 ? real_ : virtual_; }

    const Vec3& scattering() const { return scattering_; }  ///< reduced, per length
    const Vec3& extinction() const { return extinction_; }  ///< reduced, per length
    const Vec3& falloff() const { return falloff_; }  ///< of far light: it goes as exp(-falloff r)

private:
    Vec3 scattering_, extinction_, falloff_;
    Vec3 albedo_;          ///< reduced
    Vec3 real_, virtual_;  ///< depth and height of the two sources
};

}  // namespace candelabra
