// SPDX-License-Identifier: GPL-3.0-or-later
// The random numbers of surveys of cells, named by what they decide. Each is a function of that and
// of the numbers of the trial, so that a cell is the same whoever makes it.
#pragma once

#include "base/random.h"

#include <cstdint>

namespace candelabra {

/// Decisions about a ray that looks around in a cell. The numbers are those of the line, place or
/// bin, and of the try.
enum class CellDraw : std::uint32_t {
    place_x = 1,
    place_y,
    place_z,
    line_height,
    line_turn,
    ring = 10,  ///< place in a bin of the light guide
    sector
};
/// Tries for places: those on lines that look for surfaces, and those anywhere in a cell.
inline constexpr std::uint32_t on_lines = 0, anywhere = 1;

/// Decisions about a shadow ray to a luminaire that is chosen from a whole cut.
enum class ShadowRayDraw : std::uint64_t { choice = 3, point_u, point_v };

/// Decisions about a shadow ray to a luminaire of one entry of a cut. The numbers are those of the
/// entry and of the ray.
enum class EntryDraw : std::uint32_t { member, point_u, point_v, further_members };

/// Decisions about a ray from a cell to the sky. The number is that of the ray.
enum class SkyDraw : std::uint32_t { way, u, v };

inline Key survey_key(std::uint32_t ray, SkyDraw draw) {
    return Key::of(Survey::sky, ray, 0, static_cast<std::uint32_t>(draw));
}
inline Key survey_key(std::uint64_t first, std::uint32_t second, CellDraw draw) {
    return Key::of(Survey::cell, first, second, static_cast<std::uint32_t>(draw));
}
inline Key survey_key(std::uint32_t ray, ShadowRayDraw draw) {
    return Key::of(Survey::cell, static_cast<std::uint64_t>(draw), ray, 0);
}
inline Key survey_key(std::uint32_t entry, std::uint32_t ray, EntryDraw draw) {
    return Key::of(Survey::visibility, entry, ray, static_cast<std::uint32_t>(draw));
}

/// Uniform in [0, 1), for the numbers of a trial and its decision.
template <class... Trial>
double survey_number(const Trial&... trial) {
    return uniform(survey_key(trial...), Purpose::survey);
}

}  // namespace candelabra
