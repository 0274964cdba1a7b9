// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/line_search.h"

#include "base/work_watch.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace candelabra {

namespace {

/// Maximum number of stretches examined along one line.
constexpr int max_stretches = 10'000;

/// Minimum length of stretches without values that are examined, as a fraction of the whole line.
constexpr double smallest_gap = 0.01;

struct Place {
    double t, value;
};

/// Whether the function cannot reach 0 in a stretch of this length with values of one sign at both
/// ends, because its slopes are too small.
bool stays_away(double first, double last, Bounds slope, double length) {
    if (first < 0) {
        first = -first, last = -last;
        slope = {-slope.high, -slope.low};
    }
    // Minimum of the lines with the steepest slopes from both ends.
    const double least = (first * slope.high - last * slope.low + slope.low * slope.high * length) /
                         (slope.high - slope.low);
    return least > 0;
}

class Search {
public:
    Search(const LineFunction& f, double detail, double precision)
        : f_(f), detail_(detail), precision_(precision) {}

    /// Restricts the search to crossings in `wanted`, or to the first of them.
    void want(const Interval& wanted, bool first) {
        wanted_ = wanted;
        first_ = first;
    }

    void look(const Place& first, const Place& last) {
        if (done_ || last.t < wanted_.min || first.t > wanted_.max) return;
        count_work(1);
        const bool crosses = is_below(first.value) != is_below(last.value);
        const double length = last.t - first.t;
        // A short stretch without a value at either end is taken to have none in between.
        if (std::isnan(first.value) && std::isnan(last.value) && length < gap_) return;
        const Enclosure known = f_.within({first.t, last.t});
        if (!crosses && (known.value.low > 0 || known.value.high < 0 ||
                         stays_away(first.value, last.value, known.slope, length)))
            return;
        const bool one_way = known.slope.low >= 0 || known.slope.high <= 0;
        if (one_way || length < detail_ || ++stretches_ > max_stretches) {
            if (crosses) take({solve(first, last), is_below(last.value)});
            return;
        }
        const double middle = 0.5 * (first.t + last.t);
        const Place between{middle, f_.at(middle)};
        look(first, between);
        look(between, last);
    }

    void look_at(const Interval& range) {
        gap_ = smallest_gap * (range.max - range.min);
        look({range.min, f_.at(range.min)}, {range.max, f_.at(range.max)});
    }

    std::vector<SignChange> found;

private:
    void take(const SignChange& change) {
        found.push_back(change);
        done_ = first_ && change.t > wanted_.min;
    }

    /// The sign change between two places with different signs.
    double solve(const Place& first, const Place& last) const {
        const auto known = [](double value) {
            return std::isnan(value) ? 1 : std::clamp(value, -1e200, 1e200);
        };
        const auto near = [&](double a, double b) { return b - a <= precision_; };
        std::uintmax_t steps = 200;
        const auto [a, b] = boost::math::tools::toms748_solve(
            [&](double t) { return known(f_.at(t)); }, first.t, last.t, known(first.value),
            known(last.value), near, steps);
        return 0.5 * (a + b);
    }

    const LineFunction& f_;
    double detail_, precision_;
    double gap_ = 0;  ///< below this, no values are searched for between places without any
    Interval wanted_{-std::numeric_limits<double>::infinity()};
    bool first_ = false, done_ = false;
    int stretches_ = 0;
};

double precision_in(const Interval& range) {
    return 1e-14 * std::max(std::abs(range.min), std::abs(range.max));
}

std::vector<SignChange> found_by(Search search, const Interval& range) {
    search.look_at(range);
    return std::move(search.found);
}

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
    std::vector<double> places;
    for (const SignChange& change : found_by(Search(f, detail, precision_in(range)), range))
        places.push_back(change.t);
    return places;
}

std::vector<SignChange> changes_between(const LineFunction& f, const Interval& range, double detail,
                                        const Interval& wanted) {
    Search search(f, detail, precision_in(range));
    search.want(wanted, false);
    return found_by(std::move(search), range);
}

std::vector<SignChange> nearest_changes(const LineFunction& f, const Interval& range, double detail,
                                        const Interval& wanted) {
    Search search(f, detail, precision_in(range));
    search.want(wanted, true);
    return found_by(std::move(search), range);
}

}  // namespace candelabra
