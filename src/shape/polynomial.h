// SPDX-License-Identifier: GPL-3.0-or-later
// Zero sets of polynomials of x, y and z: cubic, quartic and poly, and polynomial, which is written
// term by term, of any degree up to 35.
// Rays are tested against the AlgebraicSurface built from each of them.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The points where a polynomial is at most 0. Coefficients are ordered by decreasing powers of x;
/// for each, by decreasing powers of y up to the remaining degree; for each, by decreasing powers
/// of z. The constant is last.
struct AlgebraicSurface {
    int degree = 0;
    std::vector<double> factors;  ///< factor_count(degree) of them
};

/// Number of terms up to a degree.
constexpr std::size_t factor_count(int degree) {
    const auto n = static_cast<std::size_t>(degree);
    return (n + 1) * (n + 2) * (n + 3) / 6;
}

/// A surface of degree 3.
struct Cubic {
    std::vector<double> factors;

    static const ItemInfo vocabulary;
};

/// A surface of degree 4.
struct Quartic {
    std::vector<double> factors;

    static const ItemInfo vocabulary;
};

/// A surface of any degree.
struct Poly {
    int degree = 2;
    std::vector<double> factors;

    static const ItemInfo vocabulary;
};

/// `xyz(2, 0, 1): 3`, which is 3 x^2 z.
struct PolynomialTerm {
    int x = 0, y = 0, z = 0;
    double factor = 0;

    static const ItemInfo vocabulary;
};

/// A surface of any degree. Missing terms are 0; of repeated ones the last counts.
struct Polynomial {
    int degree = 2;
    std::vector<PolynomialTerm> terms;

    static const ItemInfo vocabulary;
};

AlgebraicSurface build(const Cubic&);
AlgebraicSurface build(const Quartic&);
AlgebraicSurface build(const Poly&);
AlgebraicSurface build(const Polynomial&);
/// Error that the ranges of single fields do not exclude (number of factors), as a sentence; empty
/// when there is none.
std::string problem(const Cubic&);
std::string problem(const Quartic&);
std::string problem(const Poly&);
std::string problem(const Polynomial&);
std::string vanishes(const Cubic&);
std::string vanishes(const Quartic&);
std::string vanishes(const Poly&);
std::string vanishes(const Polynomial&);

/// Infinite, because the extent of the surface is not known.
Box bounds(const AlgebraicSurface&);
void crossings(const AlgebraicSurface&, const Ray&, Crossings&);
void crossings_between(const AlgebraicSurface&, const Ray&, const Interval&, Crossings&);
bool inside(const AlgebraicSurface&, const Vec3&);

}  // namespace candelabra
