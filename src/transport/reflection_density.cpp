// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflection_density.h"

#include "base/box.h"
#include "base/elementary.h"

#include <cmath>
#include <cstddef>
#include <optional>
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

double least_width_of(std::span<const Vec3> positions) {
    Box all;
    for (const Vec3& position : positions) all = join(all, position);
    const double whole = max_component(all.size());
    return narrowest * (whole > 0 ? whole : 1);
}

}  // namespace

ReflectionDensity::ReflectionDensity(std::vector<Vec3> positions) {
    const double least_width = least_width_of(positions);
    const auto density = [least_width](std::span<const Vec3> part, const Vec3& size,
                                       int axis) -> std::optional<double> {
        if (part.size() >= divided_from && size[axis] > least_width) return std::nullopt;
        // The area of a surface that crosses a box is about that of its greatest side.
        const double least = std::fmin(size.x, std::fmin(size.y, size.z));
        const double longest = std::fmax(size[axis], least_width),
                     middle = std::fmax(size.x + size.y + size.z - size[axis] - least, least_width);
        // Positions lie up to half of their spacing within the surface that they stand for.
        const double across = std::sqrt(static_cast<double>(part.size())) - 1;
        return across * across / (longest * middle);
    };
    space_ = HalvedSpace(
        std::span(positions), [](const Vec3& position) { return position; }, density, division);
}

ReflectionDensity ReflectionDensity::in_air(std::vector<Vec3> positions) {
    const double least_width = least_width_of(positions);
    const auto density = [least_width](std::span<const Vec3> part, const Vec3& size,
                                       int axis) -> std::optional<double> {
        if (part.size() >= divided_from && size[axis] > least_width) return std::nullopt;
        const Vec3 wide = glm::max(size, Vec3(least_width));
        const double across = math::cbrt(static_cast<double>(part.size())) - 1;
        return across * across * across / (wide.x * wide.y * wide.z);
    };
    ReflectionDensity result;
    result.space_ = HalvedSpace(
        std::span(positions), [](const Vec3& position) { return position; }, density, division);
    return result;
}

}  // namespace candelabra
