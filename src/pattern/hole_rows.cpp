// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/hole_rows.h"

#include "base/infinity.h"
#include "base/lanes.h"
#include "base/target_clones.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace candelabra {

namespace {

/// Relative bound on the error of rounding coordinates and their differences to single precision.
constexpr double rounding = 4 * std::numeric_limits<float>::epsilon();

double size_of(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// Returns the step's black hole if it is one that is not repeated; null otherwise.
const BlackHole* single_hole(const WarpStep& step) {
    const Warp* warp = std::get_if<Warp>(&step);
    const BlackHole* hole = warp ? std::get_if<BlackHole>(warp) : nullptr;
    return hole && hole->repeat == Vec3(0) ? hole : nullptr;
}

/// Returns a bit for each ball that may contain the point; `x` to `radius` are the arrays of a Row.
CANDELABRA_TARGET_CLONES
std::uint32_t may_hold(const float* x, const float* y, const float* z, const float* radius,
                       const std::array<float, 4>& point) {
    const Lanes dx = load_lanes(x) - point[0], dy = load_lanes(y) - point[1];
    const Lanes dz = load_lanes(z) - point[2], reach = load_lanes(radius) + point[3];
    // NaN counts as inside.
    return marked(~(dx * dx + dy * dy + dz * dz > reach * reach));
}

}  // namespace

HoleRows::HoleRows(std::span<const WarpStep> steps)
    : rows_((steps.size() + width - 1) / width), count_(steps.size()) {
    static_assert(width == lane_count);
    for (std::size_t i = 0; i < count_; ++i) {
        Row& row = rows_[i / width];
        const BlackHole* hole = single_hole(steps[i]);
        row.radius[i % width] = static_cast<float>(infinity);
        if (!hole) continue;
        row.x[i % width] = static_cast<float>(hole->centre.x);
        row.y[i % width] = static_cast<float>(hole->centre.y);
        row.z[i % width] = static_cast<float>(hole->centre.z);
        const double radius = hole->radius + rounding * (hole->radius + size_of(hole->centre));
        row.radius[i % width] = static_cast<float>(radius);
    }
}

std::size_t HoleRows::left(const Vec3& point, std::size_t end) const {
    if (end > count_) return end;
    const std::array<float, 4> here = {static_cast<float>(point.x), static_cast<float>(point.y),
                                       static_cast<float>(point.z),
                                       static_cast<float>(rounding * size_of(point))};
    while (end > 0) {
        const std::size_t first = (end - 1) / width * width;
        const Row& row = rows_[first / width];
        const std::uint32_t asked = (2u << (end - 1 - first)) - 1;
        const std::uint32_t holding =
            asked & may_hold(row.x.data(), row.y.data(), row.z.data(), row.radius.data(), here);
        if (holding != 0) return first + static_cast<std::size_t>(std::bit_width(holding));
        end = first;
    }
    return 0;
}

Vec3 HoleRows::warped(std::span<const WarpStep> steps, Vec3 point) const {
    for (std::size_t end = steps.size();;) {
        const std::size_t begun = std::exchange(end, left(point, end));
        // Each skipped hole would have limited the point in the same way.
        if (end < begun) point = within_reach(point);
        if (end == 0) return within_reach(point);
        point = undone(steps[--end], point);
    }
}

Handle<HoleRows> hole_rows(std::span<const WarpStep> steps) {
    const auto holes = std::ranges::count_if(
        steps, [](const WarpStep& step) { return single_hole(step) != nullptr; });
    if (static_cast<std::size_t>(holes) < HoleRows::least) return nullptr;
    return make_handle<HoleRows>(steps);
}

}  // namespace candelabra
