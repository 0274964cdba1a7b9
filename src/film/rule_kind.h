// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of sample rules, each of which decides how many samples pixels get, and where in
// the pixel their rays go.
#pragma once

#include "base/random.h"
#include "base/vector.h"
#include "camera/camera.h"
#include "camera/film_settings.h"
#include "film/tile_samples.h"
#include "scene/settings.h"

#include <concepts>
#include <cstdint>
#include <optional>

namespace candelabra {

/// What decides how many samples a pixel gets beyond those of the first round.
enum class DecidedBy : std::uint8_t {
    settings,    ///< nothing else: all pixels get the requested number
    neighbours,  ///< the samples of adjacent pixels, which a shard must take, too
    pixel,       ///< its own samples
    tile         ///< the rays of the tile that is made: the first round is the last
};

/// A picture for which a rule is chosen.
struct RuleChoice {
    const RenderSettings& settings;
    const Projection& camera;
    const FilmSettings& film;
    double assumed_gamma;
    bool random;  ///< two samples of one point of the picture may differ
    bool quiet;   ///< the light hardly differs between samples

    /// Whether the number of samples or their noise is requested.
    bool is_requested() const { return settings.samples > 0 || settings.noise > 0; }

    /// Whether pixels can be compared by single rays. A filter wider than a pixel needs samples
    /// over its whole support, not in squares of the pixel.
    bool compares_rays() const {
        return !is_requested() && settings.antialias && !random && !camera.mesh &&
               film.filter() == FilterShape::box;
    }
};

/// Numbers of samples for the first round.
struct FirstSamples {
    int usual;      ///< for the noise of the light
    int least = 0;  ///< to see all moments of the shutter, and all that a pixel of the camera sees
};

template <class T>
concept SampleRuleKind = requires(const T& rule, const RuleChoice& choice,
                                  const RenderSettings& settings, const FirstSamples& wanted,
                                  std::uint32_t number, const Key& key, RenderState& state,
                                  TileSamples& tile) {
    // The rule, if it is the one for the picture.
    { T::chosen(choice) } -> std::same_as<std::optional<T>>;
    { rule.decided_by(settings) } -> std::same_as<DecidedBy>;
    // Number of samples per pixel in the first round.
    { rule.first(wanted) } -> std::same_as<int>;
    // Greatest number that rounds can plan, given the number of the first.
    { rule.most(settings, number) } -> std::same_as<std::uint32_t>;
    // Plans the samples of a round after the first from the samples of the rounds before.
    rule.refine(state, settings);
    // Position of a sample's ray from the left and upper edge of its pixel, in pixels; nothing: the
    // film's filter draws it.
    { rule.place(key) } -> std::same_as<std::optional<Vec2>>;
    // Makes samples of a tile, up to `number` in a pixel. Returns how many of the planned samples
    // are done, or turned out to be needless.
    { rule.make(tile, number) } -> std::same_as<std::uint64_t>;
};

}  // namespace candelabra
