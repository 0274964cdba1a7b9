// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/pixel_filter.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

double reach_of(FilterShape shape) {
    switch (shape) {
        case FilterShape::box:
            return 0.5;
        case FilterShape::triangle:
            return 1;
        case FilterShape::mitchell:
            return 2;
        case FilterShape::blackman_harris:
            return 1.5;
    }
    return 0.5;
}

double mitchell(double x) {
    constexpr double b = 1.0 / 3, c = 1.0 / 3;
    if (x < 1)
        return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + 6 - 2 * b) / 6;
    return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + 8 * b +
            24 * c) /
           6;
}

double blackman_harris(double x, double reach) {
    constexpr double a0 = 0.35875, a1 = 0.48829, a2 = 0.14128, a3 = 0.01168;
    const double turn = std::numbers::pi * x / reach;
    return (a0 + a1 * math::cos(turn) + a2 * math::cos(2 * turn) + a3 * math::cos(3 * turn)) /
           (2 * reach * a0);
}

}  // namespace

double PixelFilter::height(FilterShape shape, double distance) {
    const double x = std::abs(distance), reach = reach_of(shape);
    if (x > reach) return 0;
    switch (shape) {
        case FilterShape::box:
            return 1;
        case FilterShape::triangle:
            return 1 - x;
        case FilterShape::mitchell:
            return mitchell(x);
        case FilterShape::blackman_harris:
            return blackman_harris(x, reach);
    }
    return 0;
}

PixelFilter::Lobes PixelFilter::lobes(FilterShape shape, bool negative) {
    Lobes made;
    made.reach = reach_of(shape);
    const double step = 2 * made.reach / parts;
    for (std::size_t i = 0; i < parts; ++i) {
        const double height =
            PixelFilter::height(shape, (static_cast<double>(i) + 0.5) * step - made.reach);
        made.sums[i + 1] = made.sums[i] + std::max(negative ? -height : height, 0.0) * step;
    }
    made.all = made.sums[parts];
    if (made.all > 0)
        for (double& sum : made.sums) sum /= made.all;
    return made;
}

double PixelFilter::Lobes::at(double share) const {
    const auto end = std::upper_bound(sums.begin() + 1, sums.end() - 1, share);
    const double before = *(end - 1), part = *end - before;
    const double place = static_cast<double>(end - 1 - sums.begin()) +
                         (part > 0 ? std::clamp((share - before) / part, 0.0, 1.0) : 0.5);
    return place * 2 * reach / parts - reach;
}

PixelFilter::PixelFilter(FilterShape shape)
    : shape_(shape),
      above_(lobes(shape, false)),
      below_(lobes(shape, true)),
      both_above_(above_.all * above_.all),
      both_below_(below_.all * below_.all),
      mixed_(2 * above_.all * below_.all) {}

std::uint32_t PixelFilter::negatives_among(std::uint32_t samples) const {
    const double share = mixed_ / (both_above_ + both_below_ + mixed_);
    return static_cast<std::uint32_t>(samples * share + 0.5);
}

FilteredPlace PixelFilter::place(const Key& key) const {
    if (is_box()) return {{uniform(key, Purpose::pixel_x), uniform(key, Purpose::pixel_y)}, false};
    const std::uint32_t before = negatives_among(key.sample);
    const bool negative = negatives_among(key.sample + 1) > before;
    // A subsequence of an evenly distributed sequence need not be even, so each sign has its own
    // sequence.
    Key own = key.with_branch(negative ? 1 : 0);
    own.sample = negative ? before : key.sample - before;
    const double u = uniform(own, Purpose::pixel_x), v = uniform(own, Purpose::pixel_y);
    const double first = negative ? 0.5 : both_above_ / (both_above_ + both_below_);
    const bool is_first = u < first;
    const double rest = is_first ? u / first : (u - first) / (1 - first);
    const Lobes& across = is_first ? above_ : below_;
    const Lobes& down = is_first == negative ? below_ : above_;
    return {{0.5 + across.at(rest), 0.5 + down.at(v)}, negative};
}

}  // namespace candelabra
