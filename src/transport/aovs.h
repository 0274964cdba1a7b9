// SPDX-License-Identifier: GPL-3.0-or-later
// Values of each pixel besides its colour, as sums in the film, which can be stopped, continued and
// merged like the picture's: alpha, properties of the visible surface, and the light of each
// statement of the scene. The renderer gathers them; they become layers of files.
#pragma once

#include "base/exact_sum.h"
#include "transport/primary_hit.h"

#include <cstddef>
#include <span>

namespace candelabra {

class Integrator;

struct Aovs {
    bool alpha = false;    ///< how clear the background is
    bool surface = false;  ///< albedo, normal, depth and object
    bool lights = false;   ///< red, green and blue of each of Provenance::light_statements
    bool smooth = false;   ///< red, green and blue of compressed samples, which the renderer adds
    /// For the denoiser: red, green and blue of what the camera sees of things that glow, and
    /// of the squares of all other light, which the renderer adds.
    bool squares = false;
    bool luminance = false;    ///< in cd/m2, added by the renderer
    bool illuminance = false;  ///< of the visible surface in lux, added by the renderer

    /// Number of sums that each pixel has.
    std::size_t count(const World& world) const {
        return count(world.provenance.light_statements.size());
    }
    std::size_t count(std::size_t statements) const {
        return first_light() + (lights ? 3 * statements : 0);
    }

    // Indices of the first sums. Albedo and normal are summed over all samples; depth and object
    // are those at the pixel's centre, 0 where there is no surface.
    std::size_t first_smooth() const { return alpha ? 1 : 0; }
    std::size_t first_glow() const { return first_smooth() + (smooth ? 3 : 0); }
    std::size_t first_square() const { return first_glow() + 3; }
    std::size_t albedo() const { return first_glow() + (squares ? 6 : 0); }
    std::size_t normal() const { return albedo() + 3; }
    std::size_t depth() const { return albedo() + 6; }
    std::size_t object() const { return albedo() + 7; }
    std::size_t first_luminance() const { return albedo() + (surface ? 8 : 0); }
    std::size_t first_illuminance() const { return first_luminance() + (luminance ? 1 : 0); }
    std::size_t first_light() const { return first_illuminance() + (illuminance ? 1 : 0); }

    friend bool operator==(const Aovs&, const Aovs&) = default;
};

/// Adds the values of the sample that the integrator has just followed. If the work ends meanwhile,
/// none is added.
void gather_sample(const Aovs&, const World&, const Ray&, Integrator&, std::span<ExactSum>);

/// The hit at the centre of a pixel; that of a ray that meets nothing if it is not wanted.
PrimaryHit seen_at_middle(const Aovs&, const Shot&, const PicturePoint&);

/// Adds the values at the centre of a pixel. To be called once for each pixel.
void gather_middle(const Aovs&, const PrimaryHit& seen, std::span<ExactSum>);

}  // namespace candelabra
