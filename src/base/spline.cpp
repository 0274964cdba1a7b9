// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/spline.h"

#include <algorithm>
#include <utility>

namespace candelabra {

namespace {

using Components = Spline::Components;

bool before(const Spline::Knot& knot, double t) { return knot.t < t; }

/// Weighted sum of points.
template <std::size_t N>
Components mixed(const std::array<double, N>& weights, const std::array<const Components*, N>& at) {
    Components result{};
    for (std::size_t k = 0; k < N; ++k)
        for (std::size_t c = 0; c < result.size(); ++c) result[c] += weights[k] * (*at[k])[c];
    return result;
}

}  // namespace

void Spline::insert(std::vector<Knot>& knots, const Knot& knot) {
    if (knots.empty() || knot.t > knots.back().t) {
        knots.push_back(knot);
        return;
    }
    if (knot.t == knots.back().t) return;
    const auto place = std::lower_bound(knots.begin(), knots.end(), knot.t, before);
    if (place->t == knot.t)
        *place = knot;
    else
        knots.insert(place, knot);
}

Spline::Spline(std::vector<Knot> knots, std::size_t components, Kind kind)
    : knots_(std::move(knots)), second_(knots_.size()), components_(components), kind_(kind) {
    bend();
}

/// Computes the second derivatives M of the natural spline. With h the distances and b the slopes
/// between knots, h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (b1 - b0) for three successive knots, and M =
/// 0 at both ends. The tridiagonal system is solved by forward elimination and back substitution.
void Spline::bend() {
    const std::size_t n = knots_.size();
    if (n < 3) return;
    std::vector<double> factor(n);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double h0 = knots_[i].t - knots_[i - 1].t, h1 = knots_[i + 1].t - knots_[i].t;
        const double pivot = 2 * (h0 + h1) - h0 * factor[i - 1];
        factor[i] = h1 / pivot;
        for (std::size_t c = 0; c < components_; ++c) {
            const double b0 = (knots_[i].at[c] - knots_[i - 1].at[c]) / h0;
            const double b1 = (knots_[i + 1].at[c] - knots_[i].at[c]) / h1;
            second_[i][c] = (6 * (b1 - b0) - h0 * second_[i - 1][c]) / pivot;
        }
    }
    for (std::size_t i = n - 2; i > 0; --i)
        for (std::size_t c = 0; c < components_; ++c)
            second_[i][c] -= factor[i] * second_[i + 1][c];
}

/// Returns i with t between knots i and i + 1. Precondition: t is between the first and the last
/// knot.
std::size_t Spline::segment(double t) const {
    const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t,
                                        [](double t, const Knot& knot) { return t < knot.t; });
    return static_cast<std::size_t>(after - knots_.begin()) - 1;
}

Components Spline::linear(double t, std::size_t i) const {
    const Knot &a = knots_[i], &b = knots_[i + 1];
    const double u = (t - a.t) / (b.t - a.t);
    return mixed<2>({1 - u, u}, {&a.at, &b.at});
}

/// Lagrange form of the parabola through the end of the segment and the two knots before it.
Components Spline::quadratic(double t, std::size_t i) const {
    const std::size_t first = i > 0 ? i - 1 : 0;
    const Knot &a = knots_[first], &b = knots_[first + 1], &c = knots_[first + 2];
    return mixed<3>({(t - b.t) * (t - c.t) / ((a.t - b.t) * (a.t - c.t)),
                     (t - a.t) * (t - c.t) / ((b.t - a.t) * (b.t - c.t)),
                     (t - a.t) * (t - b.t) / ((c.t - a.t) * (c.t - b.t))},
                    {&a.at, &b.at, &c.at});
}

/// Hermite form; the tangent at a knot is the mean of the slopes on both sides.
Components Spline::cubic(double t, std::size_t i) const {
    const Knot &a = knots_[i], &b = knots_[i + 1];
    const double h = b.t - a.t, u = (t - a.t) / h;
    const auto slope = [&](std::size_t k, std::size_t c) {
        return (knots_[k + 1].at[c] - knots_[k].at[c]) / (knots_[k + 1].t - knots_[k].t);
    };
    Components start{}, end{};
    for (std::size_t c = 0; c < components_; ++c) {
        start[c] = h / 2 * (slope(i - 1, c) + slope(i, c));
        end[c] = h / 2 * (slope(i, c) + slope(i + 1, c));
    }
    const double v = 1 - u;
    return mixed<4>({v * v * (1 + 2 * u), u * u * (3 - 2 * u), u * v * v, -u * u * v},
                    {&a.at, &b.at, &start, &end});
}

Components Spline::natural(double t, std::size_t i) const {
    const Knot &a = knots_[i], &b = knots_[i + 1];
    const double h = b.t - a.t, u = (t - a.t) / h, v = 1 - u;
    return mixed<4>({v, u, h * h / 6 * (v * v * v - v), h * h / 6 * (u * u * u - u)},
                    {&a.at, &b.at, &second_[i], &second_[i + 1]});
}

Components Spline::at(double t, Kind kind) const {
    const std::size_t n = knots_.size();
    if (kind == Kind::cubic && n == 2) return mixed<2>({0.5, 0.5}, {&knots_[0].at, &knots_[1].at});
    // The knots at which the curve begins and ends.
    const std::size_t first = kind == Kind::cubic && n > 2 ? 1 : 0;
    const std::size_t last = n - 1 - first;
    if (!(t > knots_[first].t)) return knots_[first].at;
    if (t >= knots_[last].t) return knots_[last].at;
    const std::size_t i = segment(t);
    if (n == 2 || kind == Kind::linear) return linear(t, i);
    return kind == Kind::quadratic ? quadratic(t, i)
           : kind == Kind::cubic   ? cubic(t, i)
                                   : natural(t, i);
}

}  // namespace candelabra
