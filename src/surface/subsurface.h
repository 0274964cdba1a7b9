// SPDX-License-Identifier: GPL-3.0-or-later
// Subsurface scattering: its parameters, and the dipole approximation (Jensen, Marschner, Levoy,
// Hanrahan, "A Practical Model for Subsurface Light Transport", 2001), with POV-Ray 3.7's mapping
// of the parameters to the model. Used by the renderer.
#pragma once

#include "base/rgb.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The block in a finish.
struct Subsurface {
    Rgb translucency = Rgb(0);  ///< mean free path of scattering in millimetres; 0: opaque

    static const ItemInfo vocabulary;
    friend bool operator==(const Subsurface&, const Subsurface&) = default;
};

/// The block in global_settings.
struct SubsurfaceSettings {
    int samples = 50;         ///< points where light may enter, for each visible point
    int single_samples = 50;  ///< points below it where light may scatter once
    bool on = false;          ///< the block is present; finishes have no effect without it

    static const ItemInfo vocabulary;
};

/// The scattering interior of a solid, per channel, in scene units.
class Dipole {
public:
    /// `albedo` is the fraction of light that leaves the solid in total, without surface
    /// reflection, 0..1. `free_path` is the mean distance between scattering events, above 0. `ior`
    /// is the index of the inside over that of the outside.
    Dipole(const Rgb& albedo, const Rgb& free_path, double ior);

    /// Flux per area that leaves at a distance from an incident flux of 1.
    Rgb spread(double distance2) const;

    /// Distance from the surface to source 0, the real one below, or 1, the virtual one above.
    const Rgb& heights(int source) const { return source == 0 ? real_ : virtual_; }

    const Rgb& scattering() const { return scattering_; }  ///< reduced, per unit of length
    const Rgb& extinction() const { return extinction_; }  ///< reduced, per unit of length
    const Rgb& falloff() const { return falloff_; }        ///< far light goes as exp(-falloff r)

private:
    Rgb scattering_, extinction_, falloff_;
    Rgb albedo_;          ///< reduced
    Rgb real_, virtual_;  ///< depth of the real source, height of the virtual one
};

}  // namespace candelabra
