// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers as a pure function of place and purpose, so that the order of work cannot change a
// picture. Over the samples of a pixel they are Owen-scrambled Sobol points, which are more evenly
// spread than independent ones. Each number is uniform, and those of different pixels, paths,
// branches and purposes are independent.
#pragma once

#include <cstdint>

namespace candelabra {

/// The decision for which a random number is used. Each decision has a purpose of its own, and a
/// test of the house states which files make it. Appending a purpose changes no other number.
enum class Purpose : std::uint32_t {
    pixel_x,
    pixel_y,
    light_choice,
    survey,   ///< any decision of a Survey, which the key names
    light_u,  ///< place on a light, or direction to or from it: place_on_light()
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
    media_distance,       ///< where a path samples light between surfaces
    media_transmittance,  ///< seeds a RandomStream
    media_choice,
    media_event,  ///< whether the path scatters between surfaces
    media_direction_u,
    media_direction_v,
    media_lobe,
    near_reflection,  ///< whether reflected luminaires replace a nearby surface
    other_light,      ///< whether light other than theirs is sampled
    meter_u,          ///< direction that a meter faces, or in which it looks
    meter_v,
    sun_u,  ///< the point of its disc that lights a place
    sun_v,
    grid_u,  ///< the light of an area light's grid that lights a place
    grid_v,
    survey_u,  ///< the same as `survey`, for decisions of two numbers
    survey_v,
    dim_representative,  ///< which dim luminaires stand for all of them
    sender_kind,         ///< whether a light source or a luminaire sends light out
    sender_choice,       ///< the lamp that sends light out
    sent_u,              ///< direction in which a luminaire sends light out
    sent_v,
    sent_side,    ///< the side of a luminaire that sends light out
    sent_grid_u,  ///< the light of an area light's grid that sends light out
    sent_grid_v,
    seen_place,      ///< the place before the camera at which a light path is tried
    behind_on_line,  ///< whether straight light of a source goes on behind a surface
    photon_offset,   ///< shifts the photons among all lamps and targets
    photon_lamp,     ///< which of several chosen luminaires sends a photon
    photon_u,        ///< where a photon enters the ball around its target
    photon_v,
    photon_start,       ///< which of the luminaire's points on a line sends the photon
    photon_in_air,      ///< which photons in the air light a stretch of a ray
    subsurface_choice,  ///< with the next two: where light enters a solid, and which light
    subsurface_u,
    subsurface_v,
    subsurface_roulette,
    glare_u,  ///< the point of a luminaire at which a meter of glare looks
    glare_v,
    scatter_face,  ///< the triangle on which scatter() puts a point
    scatter_u,     ///< the place of the point in it
    scatter_v
};

/// Continuations of a path, and decisions beside it that need their own numbers. Appending one
/// changes no other number.
enum class Branch : std::uint32_t {
    reflection,
    refraction,
    scattering,  ///< by facets
    diffuse,
    subsurface_spread,  ///< light that spreads inside a solid
    subsurface_once,    ///< light that scatters once inside
    drawn_sources,      ///< the choice among many light sources
    source,             ///< one light source; counted
    medium,             ///< light that media scatter towards the viewer; counted
    medium_scattering,  ///< the path continues from a point between surfaces
    light_path,         ///< light from a lamp that has reached a surface; counted
    reflected           ///< the choice among reflected luminaires
};

/// Estimates by random trials that are independent of all pictures.
enum class Survey : std::uint32_t {
    cell,          ///< of the light octree
    visibility,    ///< of the entries of a cut
    bent_normals,  ///< of luminaires
    seen_area,     ///< of luminaires
    sky            ///< as seen from a cell of the light octree
};

/// Identifies the use of a random number: the seed and pixel, the sample in it, and the sequence of
/// branches of the path.
struct Key {
    std::uint64_t pixel = 0;  ///< pixel index with the seed mixed in by the renderer
    std::uint32_t sample = 0;
    std::uint32_t path = 0;    ///< hash of the branches so far; 0 for the camera ray
    std::uint32_t branch = 0;  ///< number of the shadow ray at this hit

    /// The key of the n-th of `count` shadow rays at one hit: as if the pixel had `count` times as
    /// many samples, so that all of them together are well distributed.
    Key part(int count, int n) const {
        return {pixel, sample * static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(n),
                path, branch};
    }
    Key with_branch(std::uint32_t b) const { return {pixel, sample, path, b}; }
    /// The key after one more branch; `number` distinguishes several of one kind.
    Key branched(Branch, std::uint32_t number = 0) const;

    /// Makes a key from three numbers that identify a trial of a survey; the second one counts
    /// trials.
    static Key of(Survey survey, std::uint64_t a, std::uint32_t b, std::uint32_t c) {
        return {a, b, c, static_cast<std::uint32_t>(survey)};
    }
};

/// The greatest number below 1: numbers in [0, 1) that are divided among choices and used again may
/// be rounded up to 1.
inline constexpr double below_1 = 1 - 0x1p-53;

/// Uniform in [0, 1), a multiple of 2^-53.
double uniform(const Key&, Purpose);

/// Any number of independent numbers for one key, for estimates that need an unknown number of
/// them. They are not stratified over the samples of a pixel.
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
