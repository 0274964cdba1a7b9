// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/seen_share.h"

#include "base/box.h"
#include "base/order.h"

#include <algorithm>

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
    for (std::size_t side = 0; side < of_side.size(); ++side)
        if (!of_side[side].empty()) divide(parts_[side], of_side[side]);
}

void SeenShare::divide(Parts& parts, std::span<Trial> trials) {
    Box box;
    for (const Trial& trial : trials) box = join(box, trial.position);
    const Vec3 size = box.size();
    int axis = 0;
    for (const int other : {1, 2})
        if (size[other] > size[axis]) axis = other;
    const std::size_t own = parts.size();
    parts.emplace_back();
    if (trials.size() < smallest_divided || !(size[axis] > 0)) {
        double seen = seen_before;
        for (const Trial& trial : trials) seen += trial.seen;
        parts[own].share = seen / (static_cast<double>(trials.size()) + seen_before);
        return;
    }
    sort_stably(trials, {}, [axis](const Trial& each) { return each.position[axis]; });
    const std::size_t middle = trials.size() / 2;
    parts[own].axis = static_cast<std::int8_t>(axis);
    parts[own].border = trials[middle].position[axis];
    divide(parts, trials.first(middle));
    parts[own].second = static_cast<std::uint32_t>(parts.size());
    divide(parts, trials.subspan(middle));
}

double SeenShare::at(const Vec3& position, const Vec3& normal) const {
    const Parts& parts = parts_[side_of(normal)];
    if (parts.empty()) return 1;
    std::uint32_t here = 0;
    while (parts[here].second != 0)
        here = position[parts[here].axis] < parts[here].border ? here + 1 : parts[here].second;
    return parts[here].share;
}

}  // namespace candelabra
