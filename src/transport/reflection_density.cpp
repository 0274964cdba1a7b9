// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflection_density.h"

#include "base/box.h"
#include "base/order.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace candelabra {

namespace {

/// Parts with fewer positions are not divided: the density is uncertain by the root of 1 over this
/// number.
constexpr std::size_t divided_from = 32;
/// Minimum width of a part, as a fraction of that of the whole: positions may coincide.
constexpr double narrowest = 1e-6;

/// Where sorted positions are divided: in the middle; or at the widest gap along the axis, in the
/// middle half of them, if it is a good part of their extent, so that surfaces with space between
/// them come apart. Returns the index of the first position behind.
std::size_t division(std::span<const Vec3> sorted, int axis) {
    const std::size_t count = sorted.size();
    constexpr double good_part = 0.25;
    std::size_t best = count / 2;
    double widest = good_part * (sorted.back()[axis] - sorted.front()[axis]);
    const auto gap = [&](std::size_t i) { return sorted[i][axis] - sorted[i - 1][axis]; };
    for (std::size_t i = count / 4; i <= count - count / 4; ++i)
        if (gap(i) > widest) {
            widest = gap(i);
            best = i;
        }
    return best;
}

}  // namespace

ReflectionDensity::ReflectionDensity(std::vector<Vec3> positions) {
    Box all;
    for (const Vec3& position : positions) all = join(all, position);
    const double size = max_component(all.size());
    divide(positions, 0, positions.size(), size > 0 ? size : 1);
}

void ReflectionDensity::divide(std::vector<Vec3>& positions, std::size_t first, std::size_t end,
                               double greatest) {
    Box box;
    for (std::size_t i = first; i < end; ++i) box = join(box, positions[i]);
    const Vec3 size = box.size();
    int axis = 0;
    for (int other : {1, 2})
        if (size[other] > size[axis]) axis = other;
    const std::size_t own = parts_.size();
    parts_.emplace_back();
    if (end - first < divided_from || !(size[axis] > narrowest * greatest)) {
        // The area of a surface that crosses a box is about that of its greatest side.
        const double least = std::fmin(size.x, std::fmin(size.y, size.z));
        const double longest = std::fmax(size[axis], narrowest * greatest),
                     middle = std::fmax(size.x + size.y + size.z - size[axis] - least,
                                        narrowest * greatest);
        // Positions lie up to half of their spacing within the surface that they stand for.
        const double across = std::sqrt(static_cast<double>(end - first)) - 1;
        parts_[own].density = across * across / (longest * middle);
        return;
    }
    std::span<Vec3> part(positions.data() + first, end - first);
    sort_stably(part, {}, [axis](const Vec3& each) { return each[axis]; });
    const std::size_t middle = first + division(part, axis);
    parts_[own].axis = static_cast<std::int8_t>(axis);
    parts_[own].border = positions[middle][axis];
    divide(positions, first, middle, greatest);
    parts_[own].second = static_cast<std::uint32_t>(parts_.size());
    divide(positions, middle, end, greatest);
}

double ReflectionDensity::at(const Vec3& position) const {
    std::uint32_t here = 0;
    while (parts_[here].second != 0)
        here = position[parts_[here].axis] < parts_[here].border ? here + 1 : parts_[here].second;
    return parts_[here].density;
}

}  // namespace candelabra
