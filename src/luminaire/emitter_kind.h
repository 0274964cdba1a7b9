// SPDX-License-Identifier: GPL-3.0-or-later
// What every kind of emitter must be able to do: surfaces that glow. (Glowing media are boxes of
// their own, in volume.h.) A new kind is a struct in luminaire.h, an
// alternative of Emitter, and these six functions in a file of its own; luminaire.h says what each
// returns. tests/conformance/emitter_test.cpp tests them for each kind.
#pragma once

#include "luminaire/luminaire.h"

#include <concepts>
#include <optional>
#include <variant>

namespace candelabra {

template <class T>
concept EmitterKind = requires(const T& emitter, double luminance, const Receiver& receiver,
                               const Vec3& v, const Vec2& u, LightHits& hits,
                               const EmissionDraw& draw) {
    // Where it is and how it emits, if the luminance of its brightest point is the given one.
    { bounds(emitter, luminance) } -> std::same_as<LightBounds>;
    // The irradiance that it gives if nothing is in the way.
    { unoccluded(emitter, luminance, receiver) } -> std::same_as<double>;
    // A point of it that may be visible from a place, with its density per steradian. A second
    // function with a receiver in place of the place may take the horizon into account.
    { sample(emitter, v, u) } -> std::same_as<std::optional<LightPoint>>;
    // The points that sample() may return in a direction.
    intersect(emitter, receiver, v, hits);
    // A ray that leaves it. The number is the fraction of the rays on the inner side.
    { emit(emitter, double{}, draw) } -> std::same_as<std::optional<EmittedRay>>;
    { emitting_area(emitter) } -> std::same_as<double>;
};

template <class>
inline constexpr bool are_emitters = false;
template <class... Kinds>
inline constexpr bool are_emitters<std::variant<Kinds...>> = (EmitterKind<Kinds> && ...);

}  // namespace candelabra
