// SPDX-License-Identifier: GPL-3.0-or-later
// Yes-or-no questions about a scene, which compile() answers once.
#pragma once

namespace candelabra {

class World;

struct WorldFacts {
    /// There is fog, a rainbow or a medium outside of solids.
    bool has_air = false;
    /// There are participating media anywhere.
    bool has_media = false;
    /// One of both: something between surfaces may dim light.
    bool dims_between = false;
    /// There may be noted solids: see World::is_noted_solid().
    bool notes_solids = false;
    /// Rays may begin anywhere, so that the solids around their origin must be found fast.
    bool indexes_solids = false;

    /// Diffuse surfaces light each other, by `radiosity`.
    bool gathers_light = false;
    /// Reflected light of surfaces lights other surfaces.
    bool has_indirect_light = false;
    /// Surfaces with `conserve_energy` take what they reflect from all other light: only from what
    /// is seen behind them otherwise, as in POV-Ray.
    bool keeps_energy = false;
    /// There is a sky that may shine without being a luminaire.
    bool has_other_sky = false;
    /// There is no such sky, no air or media, and no photons.
    bool is_lit_by_lamps_only = false;
    /// Surfaces receive other light than that of luminaires, light sources and such a sky by way of
    /// diffuse surfaces.
    bool has_other_light = false;

    /// Some lights are sampled at random.
    bool light_is_drawn = false;
    /// Two samples of one point of the picture may differ, even without media and photons, by which
    /// samples differ less.
    bool differs_by_light = false;
    /// Two samples of one point of the picture may differ.
    bool left_to_chance = false;
};

/// Answers the questions from the other parts of the world, as far as these are complete.
WorldFacts facts_of(const World&);

}  // namespace candelabra
