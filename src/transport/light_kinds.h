// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of light that may count at a vertex. Each call for direct light names them all, so that
// a new kind counts nowhere by accident.
#pragma once

#include <cassert>
#include <cstdint>
#include <initializer_list>

namespace candelabra {

enum class LightKind : std::uint8_t {
    sources,        ///< light sources that are all asked, and the photons of all sources
    drawn_sources,  ///< those of which some are drawn
    luminaires,     ///< luminaires and their photons
    sky             ///< as far as it is a luminaire
};

class LightKinds {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a list stands for the set
    constexpr LightKinds(std::initializer_list<LightKind> kinds) {
        for (const LightKind kind : kinds) bits_ |= bit(kind);
    }

    constexpr bool has(LightKind kind) const { return (bits_ & bit(kind)) != 0; }
    constexpr bool has_any(LightKinds kinds) const { return (bits_ & kinds.bits_) != 0; }
    constexpr bool has_all(LightKinds kinds) const { return (bits_ & kinds.bits_) == kinds.bits_; }
    constexpr LightKinds with(LightKinds kinds) const {
        kinds.bits_ |= bits_;
        return kinds;
    }
    constexpr LightKinds without(LightKinds kinds) const {
        LightKinds rest = *this;
        rest.bits_ &= ~kinds.bits_;
        return rest;
    }

private:
    static constexpr unsigned bit(LightKind kind) { return 1U << static_cast<unsigned>(kind); }

    unsigned bits_ = 0;
};

inline constexpr LightKinds all_sources = {LightKind::sources, LightKind::drawn_sources};
inline constexpr LightKinds all_light = {LightKind::sources, LightKind::drawn_sources,
                                         LightKind::luminaires, LightKind::sky};

/// Hands out the kinds of light at one vertex whose calls for light are several: a debug build
/// stops if a kind is handed out twice.
class EachKindOnce {
public:
    LightKinds take(LightKinds kinds) {
        assert(left_.has_all(kinds));
        left_ = left_.without(kinds);
        return kinds;
    }

private:
    LightKinds left_ = all_light;
};

}  // namespace candelabra
