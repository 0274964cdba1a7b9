// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces where a polynomial of x, y and z is 0: cubic, quartic, and poly and polynomial, which is
// written term by term, of any degree up to 35.
// Rays ask the AlgebraicSurface that is built from each of them.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The points where a polynomial is not above 0. The factors come in this order: powers of x fall
/// from the degree to 0; for each, powers of y fall from what is left; for each, powers of z. The
/// constant is last.
struct AlgebraicSurface {
    int degree = 0;
    std::vector<double> factors;  ///< as many as factor_count(degree)
};

/// How many terms there are of a degree and those below.
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

/// A surface of any degree. Terms that are not there are 0; of the same ones the last counts.
struct Polynomial {
    int degree = 2;
    std::vector<PolynomialTerm> terms;

    static const ItemInfo vocabulary;
};

AlgebraicSurface build(const Cubic&);
AlgebraicSurface build(const Quartic&);
AlgebraicSurface build(const Poly&);
AlgebraicSurface build(const Polynomial&);
/// What is wrong beyond the ranges of single fields (number of factors), as a sentence; empty when
/// nothing is.
std::string problem(const Cubic&);
std::string problem(const Quartic&);
std::string problem(const Poly&);
std::string problem(const Polynomial&);

/// Infinite: where the surface ends, if it does, is not known.
Box bounds(const AlgebraicSurface&);
void crossings(const AlgebraicSurface&, const Ray&, Crossings&);
void crossings_between(const AlgebraicSurface&, const Ray&, const Interval&, Crossings&);
bool inside(const AlgebraicSurface&, const Vec3&);

}  // namespace candelabra
