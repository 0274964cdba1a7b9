// SPDX-License-Identifier: GPL-3.0-or-later
// The light that other estimates have taken from the ray of a path. Each surface, and each place in
// a medium, that sends a path on says it anew, so that no light counts twice and none is lost.
#pragma once

#include "world/photon_targets.h"

namespace candelabra {

struct Taken {
    /// Shadow rays have taken the light of the luminaires and the sky that the ray hits.
    bool by_shadow_rays = false;
    /// Photons bring the light of the luminaires that the ray hits.
    bool by_photons = false;
    /// Photons light the surface or the medium that the ray leaves: they bring what their targets
    /// send there.
    bool from_targets = false;
    /// Reflected luminaires have taken the light of luminaires, light sources and a sky that is a
    /// luminaire, as far as it reaches the ray by way of diffuse surfaces only, and of media if
    /// they light these.
    bool by_reflected = false;
    /// Where the ray leaves a surface that reflected luminaires light, its cosine to the normal
    /// there, and 1 where it leaves such a medium: the next hit, or place in a medium, decides
    /// whether they have taken its light. 0 for other rays.
    double cosine = 0;

    /// Whether the ray shows no emission of the luminaires that it hits.
    bool lamps() const { return by_shadow_rays || by_photons; }

    /// A mirror sends the ray on: shadow rays cannot have found what it shows.
    void pass_mirror(const PhotonSurface& mirror) {
        by_shadow_rays = false;
        by_photons |= from_targets && mirror.target != 0 &&
                      is_open(ways_of_luminaires.reflection, mirror.ways.reflection);
    }
    /// A surface or a medium scatters the ray. `sampled`: shadow rays ask for light from its
    /// direction; `collects`: photons light the place.
    void scatter(bool sampled, bool collects) {
        by_shadow_rays = sampled;
        from_targets = sampled && collects;
        by_photons = false;
    }
    /// Something else than a diffuse surface, or a medium that reflected luminaires light, sends
    /// the ray on.
    void leave_diffuse_surfaces() {
        by_reflected = false;
        cosine = 0;
    }
};

}  // namespace candelabra
