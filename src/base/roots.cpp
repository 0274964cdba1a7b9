// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/roots.h"

#include <optional>

namespace candelabra {

namespace {

using Coefficients = std::array<double, greatest_degree + 1>;

/// Calls use(c) with a constant number of coefficients for cubics and quartics, so that loops over
/// them are unrolled: nearly all surfaces have these degrees.
template <class Use>
auto with_known_size(std::span<const double> c, const Use& use) {
    if (c.size() == 4) return use(c.first<4>());
    if (c.size() == 5) return use(c.first<5>());
    return use(c);
}

struct ValueAndSlope {
    double value, slope;
};

template <std::size_t size>
ValueAndSlope evaluate(std::span<const double, size> c, double x) {
    double value = c.back(), slope = 0;
    for (std::size_t i = c.size() - 1; i-- > 0;) {
        slope = slope * x + value;
        value = value * x + c[i];
    }
    return {value, slope};
}

/// The root between two places at which the polynomial has opposite signs.
template <std::size_t size>
double root_between(std::span<const double, size> c, double low, double high,
                    bool negative_at_low) {
    double x = 0.5 * (low + high);
    double before = 0;  // length of Newton's last step
    for (int step = 0; step < 200; ++step) {
        const auto [value, slope] = evaluate(c, x);
        ((value < 0) == negative_at_low ? low : high) = x;
        double next = x - value / slope;
        const bool halves = !(next > low && next < high);
        if (halves) next = 0.5 * (low + high);
        const double moved = std::abs(next - x);
        x = next;
        // Near a root each step is proportional to the square of the step before, by a factor that
        // two successive steps give.
        const double rounding = 0x1p-53 * std::abs(x);
        const bool is_last = !halves && moved * moved * moved <= 0.1 * rounding * before * before;
        if (moved <= 2 * rounding || is_last || !(low < x && x < high)) break;
        before = halves ? 0 : moved;
    }
    return x;
}

/// Roots of c0 + c1 x + c2 x^2, without loss of digits if they differ much in size.
Roots of_quadratic(double c0, double c1, double c2, const Interval& range) {
    Roots found;
    const auto take = [&](double root) {
        if (range.contains(root)) found.add(root);
    };
    if (c2 == 0) {
        if (c1 != 0) take(-c0 / c1);
        return found;
    }
    const double half = -0.5 * c1, discriminant = half * half - c2 * c0;
    if (!(discriminant > 0)) return found;
    const double q = half + std::copysign(std::sqrt(discriminant), half);
    const double first = q / c2, second = q == 0 ? 0 : c0 / q;
    take(std::fmin(first, second));
    take(std::fmax(first, second));
    return found;
}

/// binomials[n][k] is n over k.
constexpr auto binomials = [] {
    std::array<std::array<double, greatest_degree + 1>, greatest_degree + 1> table{};
    for (std::size_t n = 0; n <= greatest_degree; ++n) {
        table[n][0] = 1;
        for (std::size_t k = 1; k <= n; ++k) table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
    }
    return table;
}();

/// The k-th derivative over k!, which keeps the numbers small.
std::span<double> derivative(std::span<const double> c, std::size_t k, Coefficients& space) {
    const std::size_t count = c.size() - k;
    for (std::size_t i = 0; i < count; ++i) space[i] = c[i + k] * binomials[i + k][k];
    return {space.data(), count};
}

/// Coefficients of the polynomial in the Bernstein basis on the range.
template <std::size_t size>
void to_bernstein(std::span<const double, size> c, const Interval& range, Coefficients& b) {
    const std::size_t degree = c.size() - 1;
    std::copy(c.begin(), c.end(), b.begin());
    for (std::size_t i = 0; i < degree; ++i)
        for (std::size_t j = degree; j-- > i;) b[j] += range.min * b[j + 1];
    double power = 1;
    for (std::size_t i = 0; i <= degree; ++i, power *= range.max - range.min)
        b[i] *= power / binomials[degree][i];
    for (std::size_t i = 0; i < degree; ++i)
        for (std::size_t j = degree; j > i; --j) b[j] += b[j - 1];
}

/// Number of sign changes of these coefficients: none or one is the exact number of roots
/// (Descartes' rule). Nothing if rounding may have decided a sign.
template <std::size_t size>
std::optional<int> variations(std::span<const double, size> c, const Interval& range) {
    Coefficients b;
    to_bernstein(c, range, b);
    const double farthest = std::fmax(std::abs(range.min), std::abs(range.max));
    double greatest = 0;
    for (std::size_t i = c.size(); i-- > 0;) greatest = greatest * farthest + std::abs(c[i]);
    int changes = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (!(std::abs(b[i]) > 0x1p-40 * greatest)) return std::nullopt;
        changes += i > 0 && (b[i] < 0) != (b[i - 1] < 0);
    }
    return changes;
}

/// Whether the polynomial is below 0; within its rounding error, returns `before`. So it does not
/// seem to cross zero where it only touches it.
template <std::size_t size>
bool negative_at(std::span<const double, size> c, double x, bool before) {
    double value = 0, greatest = 0;
    for (std::size_t i = c.size(); i-- > 0;) {
        value = value * x + c[i];
        greatest = greatest * std::abs(x) + std::abs(c[i]);
    }
    return std::abs(value) <= 0x1p-51 * greatest ? before : value < 0;
}

/// Finds the roots in a finite range, given those of the derivative.
template <std::size_t size>
void between(std::span<const double, size> c, const Roots& turns, const Interval& range,
             Roots& found) {
    double low = range.min;
    bool negative = polynomial(c, low) < 0;
    for (std::size_t i = 0; i <= turns.size(); ++i) {
        const bool last = i == turns.size();
        const double high = last ? range.max : turns[i];
        const bool there = last ? polynomial(c, high) < 0 : negative_at(c, high, negative);
        if (negative != there) found.add(root_between(c, low, high, negative));
        low = high;
        negative = there;
    }
}

Roots in_finite_range(std::span<const double> c, const Interval& range) {
    Roots found;
    if (!(range.min < range.max)) return found;
    const std::optional<int> changes =
        with_known_size(c, [&](auto all) { return variations(all, range); });
    if (changes == 0) return found;
    if (changes == 1) {
        found.add(with_known_size(c, [&](auto all) {
            return root_between(all, range.min, range.max, polynomial(all, range.min) < 0);
        }));
        return found;
    }
    Coefficients space;
    const std::size_t degree = c.size() - 1;
    const auto quadratic = derivative(c, degree - 2, space);
    found = of_quadratic(quadratic[0], quadratic[1], quadratic[2], range);
    for (std::size_t k = degree - 2; k-- > 0;) {
        const Roots turns = found;
        found.clear();
        with_known_size(derivative(c, k, space),
                        [&](auto all) { between(all, turns, range, found); });
    }
    return found;
}

/// Where infinite ranges are divided; not a round number, since roots often are.
constexpr double border = 1.0371;

/// Beyond the border, the polynomial in 1 / x has its roots in a finite range; for the negative
/// side it is mirrored first.
Roots beyond_border(std::span<const double> c, const Interval& range, bool mirrored) {
    if (!(range.min < range.max)) return {};
    Coefficients reversed;
    std::reverse_copy(c.begin(), c.end(), reversed.begin());
    if (mirrored)
        for (std::size_t i = 1; i < c.size(); i += 2) reversed[c.size() - 1 - i] *= -1;
    return sign_changes({reversed.data(), c.size()}, {1 / range.max, 1 / range.min});
}

}  // namespace

Roots sign_changes(std::span<const double> c, const Interval& range) {
    while (!c.empty() && c.back() == 0) c = c.first(c.size() - 1);
    if (c.size() < 2) return {};
    if (c.size() < 4) return of_quadratic(c[0], c[1], c.size() == 3 ? c[2] : 0, range);
    if (std::isfinite(range.min) && std::isfinite(range.max)) return in_finite_range(c, range);

    Roots found;
    const Roots below = beyond_border(c, {std::fmax(border, -range.max), -range.min}, true);
    for (const double root : below) found.add(-1 / root);
    const Interval middle{std::fmax(-border, range.min), std::fmin(border, range.max)};
    for (const double root : in_finite_range(c, middle)) found.add(root);
    const Roots above = beyond_border(c, {std::fmax(border, range.min), range.max}, false);
    for (std::size_t i = above.size(); i-- > 0;) found.add(1 / above[i]);
    return found;
}

Roots sign_changes(std::span<const double> c, const Interval& range, double at_min, double at_max) {
    const Roots found = sign_changes(c, range);
    const bool odd = (at_min < 0) != (at_max < 0);
    if ((found.size() % 2 == 1) == odd) return found;
    Roots result;
    if (odd) {
        const bool first = std::abs(at_min) < std::abs(at_max);
        if (first) result.add(range.min);
        for (const double root : found) result.add(root);
        if (!first) result.add(range.max);
        return result;
    }
    // One root too many lies near an end.
    const bool first = found[0] - range.min < range.max - found[found.size() - 1];
    for (std::size_t i = first ? 1 : 0; i + (first ? 0 : 1) < found.size(); ++i)
        result.add(found[i]);
    return result;
}

}  // namespace candelabra
