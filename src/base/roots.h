// SPDX-License-Identifier: GPL-3.0-or-later
// Real roots of polynomials, for intersections of rays with curved surfaces. Used by the shapes.
// Only sign changes count as roots, so that a ray that touches a surface does not cross it, and
// crossings of a closed surface come in pairs.
#pragma once

#include "base/ray.h"

#include <span>

namespace candelabra {

/// Maximum degree for sign_changes().
inline constexpr std::size_t greatest_degree = 35;

/// Roots in ascending order.
class Roots {
public:
    Roots() = default;
    Roots(const Roots& other) { *this = other; }
    Roots& operator=(const Roots& other) {
        std::copy(other.begin(), other.end(), at_.begin());
        count_ = other.count_;
        return *this;
    }

    /// If rounding errors make more roots than a polynomial can have, the last ones are dropped.
    void add(double root) {
        if (count_ < at_.size()) at_[count_++] = root;
    }
    void clear() { count_ = 0; }
    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    double operator[](std::size_t i) const { return at_[i]; }
    const double* begin() const { return at_.data(); }
    const double* end() const { return at_.data() + count_; }

private:
    std::array<double, greatest_degree> at_;
    std::size_t count_ = 0;
};

/// c[0] + c[1] x + ... + c[n] x^n.
inline double polynomial(std::span<const double> c, double x) {
    double sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + c[i];
    return sum;
}

/// Returns the sign changes of the polynomial c in the range, whose ends may be infinite. The
/// degree is at most greatest_degree; leading zeros are allowed. Between two neighbouring roots of
/// its derivative a polynomial has at most one root, which bisection finds reliably and Newton's
/// method quickly. So the roots of all derivatives are found, from the linear one up (Yuksel,
/// "High-Performance Polynomial Root Finding for Graphics", 2022), unless Descartes' rule of signs
/// says that there is no root, or only one.
Roots sign_changes(std::span<const double> c, const Interval& range);

/// The same in a finite range with known values, or at least signs, at its ends. The number of
/// roots is odd exactly if these signs differ, so that neighbours in a chain of polynomials, which
/// share the values at their ends, never lose or repeat a root between them.
Roots sign_changes(std::span<const double> c, const Interval& range, double at_min, double at_max);

}  // namespace candelabra
