// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/enclosure.h"

#include "base/elementary.h"
#include "base/infinity.h"
#include "formula/enclosed_function.h"
#include "formula/formula.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr Bounds no_slope{0, 0}, yes{1, 1}, no{0, 0}, perhaps{0, 1};

Bounds bounds(double low, double high) {
    return {std::isnan(low) ? -infinity : low, std::isnan(high) ? infinity : high};
}

double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

Enclosure truth(const Bounds& value) { return {value, value.single() ? no_slope : all_numbers}; }

Bounds is_less(const Bounds& a, const Bounds& b) {
    if (a.high < b.low) return yes;
    return a.low >= b.high ? no : perhaps;
}
Bounds is_less_equal(const Bounds& a, const Bounds& b) {
    if (a.high <= b.low) return yes;
    return a.low > b.high ? no : perhaps;
}
Bounds opposite(const Bounds& truth) { return {1 - truth.high, 1 - truth.low}; }
/// Whether the values are equal, or closer than `apart`.
Bounds is_equal(const Bounds& a, const Bounds& b, double apart) {
    if (a.high < b.low - apart || a.low > b.high + apart) return no;
    return a.single() && a == b ? yes : perhaps;
}
/// Whether the value is further from 0 than `apart`.
Bounds is_beyond(const Bounds& a, double apart) {
    if (a.low > apart || a.high < -apart) return yes;
    return a.low >= -apart && a.high <= apart ? no : perhaps;
}
Bounds conjunction(const Bounds& a, const Bounds& b) {
    return {std::min(a.low, b.low), std::min(a.high, b.high)};
}
Bounds disjunction(const Bounds& a, const Bounds& b) {
    return {std::max(a.low, b.low), std::max(a.high, b.high)};
}

Enclosure product(const Enclosure& a, const Enclosure& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}

Enclosure square(const Enclosure& a) {
    Bounds value = a.value * a.value;
    value.low = a.value.contains(0) ? 0 : std::max(0.0, value.low);
    return {value, Bounds{2, 2} * a.value * a.slope};
}

Enclosure quotient(const Enclosure& a, const Enclosure& b) {
    if (b.value.contains(0)) return Enclosure::unknown();
    const Bounds value = a.value / b.value;
    return {value, (a.slope - value * b.slope) / b.value};
}

Enclosure least(const Enclosure& a, const Enclosure& b) {
    if (a.value.high <= b.value.low) return a;
    if (b.value.high <= a.value.low) return b;
    return {conjunction(a.value, b.value), hull(a.slope, b.slope)};
}

Enclosure greatest(const Enclosure& a, const Enclosure& b) {
    if (a.value.high <= b.value.low) return b;
    if (b.value.high <= a.value.low) return a;
    return {disjunction(a.value, b.value), hull(a.slope, b.slope)};
}

/// Raises to an integer power.
Enclosure whole_power(const Enclosure& a, double n) {
    if (n == 0) return Enclosure::constant(1);
    const auto values = [&](double exponent) {
        const double low = math::pow(a.value.low, exponent),
                     high = math::pow(a.value.high, exponent);
        const bool even = std::fmod(exponent, 2) == 0;
        Bounds result = bounds(std::min(low, high), std::max(low, high));
        if (even && a.value.contains(0)) result.low = 0;
        return result;
    };
    if (n < 0 && a.value.contains(0)) return Enclosure::unknown();
    return {values(n), n == 1 ? a.slope : Bounds{n, n} * values(n - 1) * a.slope};
}

Enclosure power(Enclosure a, const Enclosure& b) {
    if (b.value.single() && std::trunc(b.value.low) == b.value.low) {
        return whole_power(a, b.value.low);
    }
    const bool cut = a.value.low < 0;
    if (a.value.high < 0) return Enclosure::unknown();
    a.value.low = std::max(a.value.low, 0.0);
    if (a.value.low == 0 && !(b.value.low > 0)) return Enclosure::unknown();
    Bounds value{infinity, -infinity};
    for (const double base : {a.value.low, a.value.high})
        for (const double exponent : {b.value.low, b.value.high}) {
            const double corner = math::pow(base, exponent);
            value = {std::min(value.low, corner), std::max(value.high, corner)};
        }
    if (cut) return {value, all_numbers};
    if (b.value.single() && b.value.low > 1) {
        const double n = b.value.low;
        return {value,
                Bounds{n * math::pow(a.value.low, n - 1), n * math::pow(a.value.high, n - 1)} *
                    a.slope};
    }
    if (a.value.low == 0) return {value, all_numbers};
    const Bounds logarithm{math::log(a.value.low), math::log(a.value.high)};
    return {value, value * (b.slope * logarithm + b.value * a.slope / a.value)};
}

Enclosure arc_tangent(const Enclosure& y, const Enclosure& x) {
    constexpr double pi = 3.1415926535897932;
    const bool cut = y.value.contains(0) && x.value.low <= 0;
    if (cut) return {{-pi, pi}, all_numbers};
    Bounds value{infinity, -infinity};
    for (const double a : {y.value.low, y.value.high})
        for (const double b : {x.value.low, x.value.high}) {
            const double corner = math::atan2(a, b);
            value = {std::min(value.low, corner), std::max(value.high, corner)};
        }
    const Bounds across = square(x).value + square(y).value;
    return {value, (x.value * y.slope - y.value * x.slope) / across};
}

/// Encloses a - b * (a / b towards zero).
Enclosure rest_of_division(const Enclosure& a, const Enclosure& b) {
    if (b.value.single() && b.value.low != 0) {
        const double size = std::abs(b.value.low);
        const double first = std::trunc(a.value.low / size), last = std::trunc(a.value.high / size);
        if (first == last) return {a.value - Bounds{first * size, first * size}, a.slope};
    }
    const double most = std::max(std::abs(b.value.low), std::abs(b.value.high));
    const double low = a.value.low < 0 ? std::max(-most, a.value.low) : 0;
    return {{low, a.value.high > 0 ? std::min(most, a.value.high) : 0}, all_numbers};
}

Enclosure whole_quotient(const Enclosure& a, const Enclosure& b) {
    if (b.value.contains(0)) return Enclosure::unknown();
    const Bounds q = a.value / b.value;
    if (!has_int32(q.low) || !has_int32(q.high)) return Enclosure::unknown();
    const Bounds value{std::trunc(q.low), std::trunc(q.high)};
    return {value, value.single() ? no_slope : all_numbers};
}

}  // namespace

Bounds operator+(const Bounds& a, const Bounds& b) {
    return bounds(a.low + b.low, a.high + b.high);
}

Bounds operator-(const Bounds& a, const Bounds& b) {
    return bounds(a.low - b.high, a.high - b.low);
}

// Products of 0 and an infinity need special care only where the fast path yields NaN.
Bounds operator*(const Bounds& a, const Bounds& b) {
    const double ll = a.low * b.low, lh = a.low * b.high, hl = a.high * b.low, hh = a.high * b.high;
    const double sum = (ll + lh) + (hl + hh);
    if (!std::isnan(sum))
        return {std::min(std::min(ll, lh), std::min(hl, hh)),
                std::max(std::max(ll, lh), std::max(hl, hh))};
    const double p = product(a.low, b.low), q = product(a.low, b.high), r = product(a.high, b.low),
                 s = product(a.high, b.high);
    return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}

Bounds operator/(const Bounds& a, const Bounds& b) {
    if (b.contains(0)) return all_numbers;
    return a * Bounds{1 / b.high, 1 / b.low};
}

Bounds hull(const Bounds& a, const Bounds& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Enclosure enclosed(Operation operation, const Enclosure& a, const Enclosure& b) {
    using enum Operation;
    // One line for each operation.
    // clang-format off
    switch (operation) {
        case copy: return a;
        case add: return {a.value + b.value, a.slope + b.slope};
        case subtract: return {a.value - b.value, a.slope - b.slope};
        case multiply: return product(a, b);
        case divide: return quotient(a, b);
        case negate: return {{-a.value.high, -a.value.low}, {-a.slope.high, -a.slope.low}};
        case less: return truth(is_less(a.value, b.value));
        case less_equal: return truth(is_less_equal(a.value, b.value));
        case equal: return truth(is_equal(a.value, b.value, 0));
        case not_equal: return truth(opposite(is_equal(a.value, b.value, 0)));
        case greater_equal: return truth(is_less_equal(b.value, a.value));
        case greater: return truth(is_less(b.value, a.value));
        case both: return truth(conjunction(is_beyond(a.value, 0), is_beyond(b.value, 0)));
        case either: return truth(disjunction(is_beyond(a.value, 0), is_beyond(b.value, 0)));
        case about_less_equal:
            return truth(disjunction(is_less_equal(a.value, b.value),
                                     is_equal(a.value, b.value, tolerance)));
        case about_equal: return truth(is_equal(a.value, b.value, tolerance));
        case about_not_equal: return truth(opposite(is_equal(a.value, b.value, tolerance)));
        case about_greater_equal:
            return truth(disjunction(is_less_equal(b.value, a.value),
                                     is_equal(a.value, b.value, tolerance)));
        case true_both:
            return truth(conjunction(is_beyond(a.value, tolerance), is_beyond(b.value, tolerance)));
        case true_either:
            return truth(disjunction(is_beyond(a.value, tolerance), is_beyond(b.value, tolerance)));
        case not_true: return truth(opposite(is_beyond(a.value, tolerance)));
        case Operation::least: return candelabra::least(a, b);
        case Operation::greatest: return candelabra::greatest(a, b);
        case Operation::power: return candelabra::power(a, b);
        case Operation::arc_tangent: return candelabra::arc_tangent(a, b);
        case Operation::remainder: return rest_of_division(a, b);
        case Operation::whole_quotient: return candelabra::whole_quotient(a, b);
        default: return Enclosure::unknown();
    }
    // clang-format on
}

namespace {

class Run {
public:
    explicit Run(const Program& program) : program_(program) {}

    bool from(std::size_t at, Enclosure* r) {
        for (;; ++at) {
            const Instruction& i = program_.code[at];
            if (++steps_ > max_steps) return false;
            switch (i.operation) {
                case Operation::apply:
                    r[i.to] = enclosed_function(i.b, r[i.a]);
                    break;
                case Operation::multiply:
                    r[i.to] = i.a == i.b ? square(r[i.a]) : product(r[i.a], r[i.b]);
                    break;
                case Operation::divide_unless:
                    if (r[i.b].value.contains(0)) return false;
                    r[i.to] = quotient(r[i.a], r[i.b]);
                    break;
                case Operation::refuse:
                    if (!(r[i.a].value == no)) return false;
                    break;
                case Operation::jump:
                case Operation::repeat:
                    at = i.to - std::size_t{1};
                    break;
                case Operation::jump_unless: {
                    const Bounds condition = is_beyond(r[i.a].value, tolerance);
                    if (!condition.single()) return both(at + 1, i.to, r);
                    if (condition == no) at = i.to - std::size_t{1};
                    break;
                }
                case Operation::call:
                    if (!program_.calls[i.a]->enclose(r + i.b, r + i.to)) return false;
                    break;
                case Operation::end:
                    return true;
                default:
                    r[i.to] = enclosed(i.operation, r[i.a], r[i.b]);
            }
        }
    }

private:
    static constexpr int max_steps = 100'000, max_branches = 8;

    /// Executes both branches of an uncertain condition and merges their registers.
    bool both(std::size_t first, std::size_t second, Enclosure* r) {
        if (branches_ == max_branches) return false;
        ++branches_;
        std::vector<Enclosure> other(r, r + program_.registers);
        const bool good = from(first, r) && from(second, other.data());
        --branches_;
        if (!good) return false;
        for (std::size_t i = 0; i < other.size(); ++i)
            if (!(r[i] == other[i])) r[i] = {hull(r[i].value, other[i].value), all_numbers};
        return true;
    }

    const Program& program_;
    int steps_ = 0;
    int branches_ = 0;  ///< number of nested conditions with both branches taken
};

}  // namespace

bool enclose(const Program& program, Enclosure* registers) {
    for (std::size_t i = 0; i < program.constants.size(); ++i)
        registers[program.inputs + i] = Enclosure::constant(program.constants[i]);
    return Run(program).from(0, registers);
}

}  // namespace candelabra
