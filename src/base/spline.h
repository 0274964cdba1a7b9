// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of one to five components through given points, in the four ways of POV-Ray's splines.
// Immutable once made, so any thread may ask. Behaviour as in POV-Ray 3.7, also at the ends.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace candelabra {

class Spline {
public:
    enum class Kind {
        linear,     ///< straight lines
        quadratic,  ///< parabolas through three points in a row
        cubic,      ///< Catmull-Rom: the first and the last point only give directions
        natural,    ///< two times continuously differentiable, no curvature at the ends
    };
    using Components = std::array<double, 5>;
    struct Knot {
        double t;
        Components at;
    };

    /// Puts a knot among others that are in order of t. It replaces one at the same t, unless that
    /// is the last one: then the new knot is ignored.
    static void insert(std::vector<Knot>& knots, const Knot& knot);

    /// Knots in order of t, at least one, as insert() makes them. Components above the count must
    /// be 0.
    Spline(std::vector<Knot> knots, std::size_t components, Kind kind);

    std::size_t components() const { return components_; }
    Kind kind() const { return kind_; }
    const std::vector<Knot>& knots() const { return knots_; }

    /// Left and right of the knots the curve stays where it ends.
    Components at(double t) const { return at(t, kind_); }
    /// The same points joined in another way.
    Components at(double t, Kind kind) const;

private:
    void bend();
    std::size_t segment(double t) const;
    Components linear(double t, std::size_t i) const;
    Components quadratic(double t, std::size_t i) const;
    Components cubic(double t, std::size_t i) const;
    Components natural(double t, std::size_t i) const;

    std::vector<Knot> knots_;
    std::vector<Components> second_;  ///< derivatives of the natural spline at the knots
    std::size_t components_;
    Kind kind_;
};

}  // namespace candelabra
