// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/line_search.h"

#include <cmath>

namespace {

/// Stretches that are looked at along one line.
constexpr int most_stretches = 10'000;

struct Place {
    double t, value;
};

/// Whether values of one sign at both ends of a stretch of this length stay away from 0, because
/// the slopes in between are too small to get there.
bool stays_away(double first, double last, Bounds slope, double length) {
    if (first < 0) {
        first = -first, last = -last;
        slope = {-slope.high, -slope.low};
    }
    // The least that lines of the steepest slopes from both ends reach.
    const double least = (first * slope.high - last * slope.low + slope.low * slope.high * length) /
                         (slope.high - slope.low);
    return least > 0;
}

class Search {
public:
    Search(const LineFunction& f, double detail, double precision)
        : f_(f), detail_(detail), precision_(precision) {}

    void look(const Place& first, const Place& last) {
        const bool crosses = is_below(first.value) != is_below(last.value);
        const double length = last.t - first.t;
        const Enclosure known = f_.within({first.t, last.t});
        if (!crosses && (known.value.low > 0 || known.value.high < 0 ||
                         stays_away(first.value, last.value, known.slope, length)))
            return;
        const bool one_way = known.slope.low >= 0 || known.slope.high <= 0;
        if (one_way || length < detail_ || ++stretches_ > most_stretches) {
            if (crosses) found.push_back(solve(first, last));
            return;
        }
        const double middle = 0.5 * (first.t + last.t);
        const Place between{middle, f_.at(middle)};
        look(first, between);
        look(between, last);
    }

    std::vector<double> found;

private:
    /// The change between two places of different signs: the false position, and the middle
    /// whenever that gets on slowly.
    double solve(Place first, Place last) const {
        for (int i = 0; i < 200 && last.t - first.t > precision_; ++i) {
            double t = first.t + (last.t - first.t) * first.value / (first.value - last.value);
            const double near = 0.25 * precision_;
            // A little beyond the change, so that both ends come near to it.
            t += t - first.t < last.t - t ? near : -near;
            if (i % 3 == 2 || !(t > first.t && t < last.t)) t = 0.5 * (first.t + last.t);
            if (t == first.t || t == last.t) break;
            const Place next{t, f_.at(t)};
            (is_below(next.value) == is_below(first.value) ? first : last) = next;
        }
        return 0.5 * (first.t + last.t);
    }

    const LineFunction& f_;
    double detail_, precision_;
    int stretches_ = 0;
};

}  // namespace

Vec3 normal_against(const Vec3& slope, const Vec3& direction, bool entering) {
    const Vec3 normal = unit(slope);
    if (!(length(normal) > 0.5)) return entering ? -direction : direction;
    const double along = dot(normal, direction);
    return (along < 0) == entering && along != 0
               ? normal
               : unit(normal - (2 * along + (entering ? 1e-9 : -1e-9)) * direction);
}

std::vector<double> sign_changes(const LineFunction& f, const Interval& range, double detail) {
    const double size = std::max(std::abs(range.min), std::abs(range.max));
    Search search(f, detail, 1e-14 * size);
    search.look({range.min, f.at(range.min)}, {range.max, f.at(range.max)});
    return std::move(search.found);
}
