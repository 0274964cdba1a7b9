// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of one to five components through given points, of the four kinds of POV-Ray's splines.
// Immutable once made, so any thread may evaluate them. Behaviour as in POV-Ray 3.7, also at the
// ends.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace candelabra {

class Spline {
public:
    enum class Kind {
        linear,     ///< line segments
        quadratic,  ///< parabolas through three consecutive points
        cubic,      ///< Catmull-Rom: the first and the last point only define tangents
        natural,    ///< twice continuously differentiable, without curvature at the ends
    };
    using Components = std::array<double, 5>;
    struct Knot {
        double t;
        Components at;
    };

    /// Inserts a knot into a list ordered by t. It replaces a knot with the same t, unless that is
    /// the last one: then the new knot is ignored.
    static void insert(std::vector<Knot>& knots, const Knot& knot);

    /// `knots` are as insert() makes them: ordered by t, and at least one. Components beyond the
    /// count must be 0.
    Spline(std::vector<Knot> knots, std::size_t components, Kind kind);

    std::size_t components() const { return components_; }
    Kind kind() const { return kind_; }
    const std::vector<Knot>& knots() const { return knots_; }

    /// Outside the range of the knots the curve is constant.
    Components at(double t) const { return at(t, kind_); }
    /// The same points with another kind of curve.
    Components at(double t, Kind kind) const;

private:
    void bend();
    std::size_t segment(double t) const;
    Components linear(double t, std::size_t i) const;
    Components quadratic(double t, std::size_t i) const;
    Components cubic(double t, std::size_t i) const;
    Components natural(double t, std::size_t i) const;

    std::vector<Knot> knots_;
    std::vector<Components> second_;  ///< second derivatives of the natural spline at the knots
    std::size_t components_;
    Kind kind_;
};

}  // namespace candelabra
