// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/seen_share.h"

#include <cmath>
#include <optional>

namespace candelabra {

namespace {

/// Parts with fewer trials are not divided.
constexpr std::size_t smallest_divided = 64;
/// Number of trials that are thought to have been seen in each part: what a part of few trials
/// misses may yet be seen.
constexpr double seen_before = 0.25;

std::size_t side_of(const Vec3& normal) {
    int axis = 0;
    for (const int other : {1, 2})
        if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
    return static_cast<std::size_t>(2 * axis + (normal[axis] < 0 ? 1 : 0));
}

}  // namespace

SeenShare::SeenShare(std::span<const Trial> trials) {
    std::array<std::vector<Trial>, 6> of_side;
    for (const Trial& trial : trials) of_side[side_of(trial.normal)].push_back(trial);
    const auto share = [](std::span<const Trial> part, const Vec3& size,
                          int axis) -> std::optional<double> {
        if (part.size() >= smallest_divided && size[axis] > 0) return std::nullopt;
        double seen = seen_before;
        for (const Trial& trial : part) seen += trial.seen;
        return seen / (static_cast<double>(part.size()) + seen_before);
    };
    const auto middle = [](std::span<const Trial> sorted, int) { return sorted.size() / 2; };
    for (std::size_t side = 0; side < of_side.size(); ++side)
        sides_[side] = HalvedSpace(
            std::span(of_side[side]), [](const Trial& trial) { return trial.position; }, share,
            middle);
}

double SeenShare::at(const Vec3& position, const Vec3& normal) const {
    const HalvedSpace& side = sides_[side_of(normal)];
    return side.empty() ? 1 : side.at(position);
}

}  // namespace candelabra
