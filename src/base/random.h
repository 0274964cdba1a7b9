// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that stand for chance: a pure function of where and what for, so that no order of work
// can change a picture. Over the samples of a pixel they are Owen-scrambled Sobol points, which are
// spread more evenly than chance would; one by one each is uniform, and those of different pixels,
// paths, branches and purposes are independent.
#pragma once

#include <cstdint>

namespace candelabra {

/// What a random number decides. A purpose appended at the end changes no other number.
enum class Purpose : std::uint32_t {
    pixel_x,
    pixel_y,
    light_choice,
    light_representative,
    light_u,
    light_v,
    grain,
    jitter_u,
    jitter_v,
    rainbow,
    lens_u,
    lens_v,
    sky_choice,
    sky_u,
    sky_v,
    facet_choice,
    facet_u,
    facet_v,
    light_roulette,
    texture_choice,
    way_choice,
    band_choice,
    bounce_u,
    bounce_v,
    roulette,
    media_distance,       ///< where a path is asked for light between surfaces
    media_transmittance,  ///< seeds a RandomStream
    media_choice,
    media_event,  ///< whether the path is scattered between surfaces
    media_direction_u,
    media_direction_v,
    media_lobe,
    near_reflection,  ///< whether reflected luminaires stand for a surface that is near
    other_light       ///< whether other light is looked for than they stand for
};

/// Ways on which a path goes on, and decisions beside it that need numbers of their own. One that
/// is appended at the end changes no other number.
enum class Branch : std::uint32_t {
    reflection,
    refraction,
    scattering,  ///< by facets
    diffuse,
    subsurface_spread,  ///< light that spreads inside of a solid
    subsurface_once,    ///< light that is scattered once inside
    drawn_sources,      ///< the choice among many light sources
    source,             ///< one light source; counted
    medium,             ///< light that media scatter to the viewer; counted
    medium_scattering,  ///< the path goes on from a point between surfaces
    light_path,         ///< light from a lamp has come to a surface; counted
    reflected           ///< the choice among reflected luminaires
};

/// What is found out by trial, apart from all pictures.
enum class Survey : std::uint32_t {
    cell,          ///< of the light octree
    visibility,    ///< of the entries of a cut
    bent_normals,  ///< of luminaires
    seen_area      ///< of luminaires
};

/// Where a random number is used: the seed and pixel, the sample in it, and the path of bounces
/// that led there.
struct Key {
    std::uint64_t pixel = 0;  ///< pixel index with the seed mixed in by the renderer
    std::uint32_t sample = 0;
    std::uint32_t path = 0;    ///< hash of the branches so far; 0 for the camera ray
    std::uint32_t branch = 0;  ///< number of the shadow ray at this hit

    /// The key of the n-th of some shadow rays at one hit: as if the pixel had so many times more
    /// samples, so that all of them together are spread well.
    Key part(int count, int n) const {
        return {pixel, sample * static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(n),
                path, branch};
    }
    Key with_branch(std::uint32_t b) const { return {pixel, sample, path, b}; }
    /// The key after one more branch; `number` tells several of one kind.
    Key branched(Branch, std::uint32_t number = 0) const;

    /// Of three numbers that tell the trials of a survey apart; the second one counts them.
    static Key of(Survey survey, std::uint64_t a, std::uint32_t b, std::uint32_t c) {
        return {a, b, c, static_cast<std::uint32_t>(survey)};
    }
};

/// Uniform in [0, 1), a multiple of 2^-53.
double uniform(const Key&, Purpose);

/// Any number of independent numbers for one key, for estimates that need an unknown number of
/// them. They are not spread evenly over the samples of a pixel.
class RandomStream {
public:
    RandomStream(const Key&, Purpose);

    /// Uniform in [0, 1).
    double next();

private:
    std::uint64_t state_;
};

/// 64 well-mixed bits of a 64-bit counter (the finaliser of SplitMix64).
std::uint64_t mix(std::uint64_t);

}  // namespace candelabra
