// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/polynomial.h"

#include "base/infinity.h"
#include "base/long_work.h"
#include "vocabulary/parts.h"
#include "vocabulary/schema.h"

#include "base/roots.h"

#include <algorithm>

namespace candelabra {

const ItemInfo Cubic::vocabulary = described<Cubic>([] {
    using F = Field<Cubic>;
    return schema<Cubic>("cubic",
                         {"The surface of a polynomial of degree 3; inside it is below 0.",
                          "cubic { <0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0> "
                          "clipped_by { box { -1, 1 } } translate y }"},
                         F{"factors", &Cubic::factors, positional,
                           "<20 factors>, of x^3, x^2 y, x^2 z, x^2, x y^2 ... to the constant"});
});

const ItemInfo Quartic::vocabulary = described<Quartic>([] {
    using F = Field<Quartic>;
    return schema<Quartic>(
        "quartic",
        {"The surface of a polynomial of degree 4; inside it is below 0.",
         "quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, "
         "1.6, 0, 0, 0, 0, 1, 0, -2.4, 0, 0.64> rotate 70*x translate 0.9*y }"},
        F{"factors", &Quartic::factors, positional,
          "<35 factors>, of x^4, x^3 y, x^3 z, x^3, x^2 y^2 ... to the constant"});
});

const ItemInfo Poly::vocabulary = described<Poly>([] {
    using F = Field<Poly>;
    return schema<Poly>("poly",
                        {"The surface of a polynomial of any degree; inside it is below 0.",
                         "poly { 2, <1, 0, 0, 0, 0.5, 0, 0, 1, 0, -0.8> translate y }"},
                        F{"degree", &Poly::degree, positional, "degree", between(2, 35)},
                        F{"factors", &Poly::factors, positional,
                          "<factors>, powers of x falling, then of y, then of z"});
});

const ItemInfo PolynomialTerm::vocabulary = described<PolynomialTerm>([] {
    using F = Field<PolynomialTerm>;
    return schema<PolynomialTerm>(
        "xyz", "A term of a polynomial, written `xyz(2, 0, 1): 3`.",
        F{"x", &PolynomialTerm::x, positional, "power of x", between(0, greatest_degree)},
        F{"y", &PolynomialTerm::y, positional, "power of y", between(0, greatest_degree)},
        F{"z", &PolynomialTerm::z, positional, "power of z", between(0, greatest_degree)},
        F{"factor", &PolynomialTerm::factor, positional, "factor"});
});

const ItemInfo Polynomial::vocabulary = described<Polynomial>([] {
    using F = Field<Polynomial>;
    return schema<Polynomial>(
        "polynomial",
        {"The surface of a polynomial of any degree; inside it is below 0.",
         "polynomial { 3, xyz(1, 1, 1): 2, xyz(2, 0, 0): 1, xyz(0, 2, 0): 1, xyz(0, 0, 2): 1, "
         "xyz(0, 0, 0): -0.9 clipped_by { sphere { 0, 1.2 } } translate 1.2*y }"},
        F{"degree", &Polynomial::degree, positional, "degree", between(2, greatest_degree)},
        parts<&Polynomial::terms>("xyz", "a term, as `xyz(2, 0, 1): 3`"));
});

namespace {

/// Arithmetic of horner() for plain numbers.
struct Plain {
    Vec3 point;

    double start() const { return 0; }
    void times(double& sum, int axis) const { sum *= point[axis]; }
    void add(double& sum, double other) const { sum += other; }
};

/// Arithmetic of horner() for numbers with their derivatives by x, y and z.
struct WithSlope {
    struct Sum {
        double value = 0;
        Vec3 slope = Vec3(0);
    };
    Vec3 point;

    Sum start() const { return {}; }
    void times(Sum& sum, int axis) const {
        sum.slope *= point[axis];
        sum.slope[axis] += sum.value;
        sum.value *= point[axis];
    }
    void add(Sum& sum, const Sum& other) const {
        sum.value += other.value;
        sum.slope += other.slope;
    }
    void add(Sum& sum, double other) const { sum.value += other; }
};

/// Arithmetic of horner() for polynomials of the ray's parameter.
struct AlongRay {
    struct Sum {
        std::array<double, greatest_degree + 2> at;  ///< uninitialized from `count` on
        std::size_t count = 1;

        Sum() { at[0] = 0; }
        bool zero() const { return count == 1 && at[0] == 0; }
    };
    Ray ray;

    Sum start() const { return {}; }
    void times(Sum& sum, int axis) const {
        // Most coefficients are 0.
        if (sum.zero()) return;
        const double here = ray.origin[axis], step = ray.direction[axis];
        sum.at[sum.count] = sum.at[sum.count - 1] * step;
        for (std::size_t i = sum.count; i-- > 1;)
            sum.at[i] = sum.at[i] * here + sum.at[i - 1] * step;
        sum.at[0] *= here;
        ++sum.count;
    }
    void add(Sum& sum, const Sum& other) const {
        if (other.zero()) return;
        for (; sum.count < other.count; ++sum.count) sum.at[sum.count] = 0;
        for (std::size_t i = 0; i < other.count; ++i) sum.at[i] += other.at[i];
    }
    void add(Sum& sum, double other) const { sum.at[0] += other; }
};

/// Evaluates the polynomial by Horner's rule, of x over y over z, in any arithmetic.
template <class Arithmetic>
auto horner(const AlgebraicSurface& surface, const Arithmetic& with) {
    const double* factor = surface.factors.data();
    auto sum = with.start();
    for (int x = surface.degree; x >= 0; --x) {
        auto of_x = with.start();
        for (int y = surface.degree - x; y >= 0; --y) {
            auto of_xy = with.start();
            for (int z = surface.degree - x - y; z >= 0; --z) {
                if (z < surface.degree - x - y) with.times(of_xy, 2);
                with.add(of_xy, *factor++);
            }
            if (y < surface.degree - x) with.times(of_x, 1);
            with.add(of_x, of_xy);
        }
        if (x < surface.degree) with.times(sum, 0);
        with.add(sum, of_x);
    }
    return sum;
}

std::string wrong_count(const std::string& name, int degree, const std::vector<double>& factors) {
    const std::size_t needed = factor_count(degree);
    if (factors.size() != needed)
        return "a `" + name + "` needs " + std::to_string(needed) + " factors, and this has " +
               std::to_string(factors.size());
    return {};
}

std::string without_surface(const std::vector<double>& factors) {
    const bool some =
        std::any_of(factors.begin(), factors.end() - 1, [](double f) { return f != 0; });
    return some ? "" : "all its factors besides the constant are 0";
}

/// Index of a term in the coefficients, which are ordered by falling powers of x, then y, then z.
std::size_t place(int degree, const PolynomialTerm& term) {
    const int without_x = degree - term.x, without_xy = without_x - term.y;
    return factor_count(without_x - 1) +
           static_cast<std::size_t>(without_xy * (without_xy + 1) / 2 + without_xy - term.z);
}

}  // namespace

AlgebraicSurface build(const Cubic& cubic) { return {3, cubic.factors}; }
AlgebraicSurface build(const Quartic& quartic) { return {4, quartic.factors}; }
AlgebraicSurface build(const Poly& poly) { return {poly.degree, poly.factors}; }
AlgebraicSurface build(const Polynomial& polynomial) {
    AlgebraicSurface surface{polynomial.degree,
                             std::vector<double>(factor_count(polynomial.degree))};
    for (const PolynomialTerm& term : polynomial.terms)
        surface.factors[place(polynomial.degree, term)] = term.factor;
    return surface;
}

std::string problem(const Cubic& cubic) { return wrong_count("cubic", 3, cubic.factors); }
std::string problem(const Quartic& quartic) { return wrong_count("quartic", 4, quartic.factors); }
std::string problem(const Poly& poly) { return wrong_count("poly", poly.degree, poly.factors); }
std::string problem(const Polynomial& polynomial) {
    const auto has_place = [&](const PolynomialTerm& term) {
        return term.x + term.y + term.z <= polynomial.degree;
    };
    const auto term = std::ranges::find_if_not(polynomial.terms, has_place);
    if (term == polynomial.terms.end())
        return wrong_count("polynomial", polynomial.degree, build(polynomial).factors);
    return "xyz(" + std::to_string(term->x) + ", " + std::to_string(term->y) + ", " +
           std::to_string(term->z) + ") is of a higher degree than the " +
           std::to_string(polynomial.degree) + " of its `polynomial`";
}

std::string vanishes(const Cubic& cubic) { return without_surface(cubic.factors); }
std::string vanishes(const Quartic& quartic) { return without_surface(quartic.factors); }
std::string vanishes(const Poly& poly) { return without_surface(poly.factors); }
std::string vanishes(const Polynomial& polynomial) {
    return without_surface(build(polynomial).factors);
}

Box bounds(const AlgebraicSurface&) { return everywhere(); }

void crossings(const AlgebraicSurface& surface, const Ray& ray, Crossings& found) {
    crossings_between(surface, ray, {-infinity, infinity}, found);
}

void crossings_between(const AlgebraicSurface& surface, const Ray& ray, const Interval& range,
                       Crossings& found) {
    const double speed = length(ray.direction);
    if (!(speed > 0)) return;
    // Computed from the point nearest to the origin, where such surfaces lie.
    constexpr std::size_t factors_of_step = 2;
    count_long_work(surface.factors.size() / factors_of_step);
    const Vec3 u = ray.direction / speed;
    const double start = -dot(ray.origin, u);
    const Ray near{ray.origin + start * u, u};
    const AlongRay::Sum along = horner(surface, AlongRay{near});
    const Interval wanted{range.min * speed - start, range.max * speed - start};
    for (const double s : sign_changes({along.at.data(), along.count}, wanted)) {
        const Vec3 normal = unit(horner(surface, WithSlope{near.at(s)}).slope);
        if (normal != Vec3(0)) found.add({(start + s) / speed, normal, dot(u, normal) < 0});
    }
}

bool inside(const AlgebraicSurface& surface, const Vec3& point) {
    constexpr std::size_t factors_of_step = 16;
    count_long_work(surface.factors.size() / factors_of_step);
    return horner(surface, Plain{point}) <= 0;
}

}  // namespace candelabra
