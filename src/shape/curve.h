// SPDX-License-Identifier: GPL-3.0-or-later
// Plane curves through control points, as pieces whose coordinates are cubic polynomials. Lathe,
// prism and text sweep them. The four kinds of splines have POV-Ray's meaning.
#pragma once

#include "base/roots.h"
#include "base/vector.h"

#include <vector>

namespace candelabra {

/// Kind of a curve: how it follows its control points.
enum CurveKind : int {
    linear_curve,     ///< straight from point to point
    quadratic_curve,  ///< through all points but the first, which shapes the first piece
    cubic_curve,      ///< through all points but the first and the last (Catmull and Rom)
    bezier_curve,     ///< each group of four points is a piece: end, two controls, end
};

/// A piece of a curve: at(u) = factors[0] + factors[1] u + ... for u from 0 to 1.
struct CurvePiece {
    std::array<Vec2, 4> factors{};
    Vec2 start = Vec2(0);  ///< at(0) and at(1) without rounding errors: neighbouring
    Vec2 end = Vec2(0);    ///< pieces share them exactly

    Vec2 at(double u) const {
        return factors[0] + u * (factors[1] + u * (factors[2] + u * factors[3]));
    }
    Vec2 slope(double u) const { return factors[1] + u * (2.0 * factors[2] + 3 * u * factors[3]); }
    /// Coefficients of dot(weights, at(u)) + constant.
    std::array<double, 4> combined(const Vec2& weights, double constant) const;
};

struct Rectangle {
    Vec2 low = Vec2(std::numeric_limits<double>::infinity());
    Vec2 high = Vec2(-std::numeric_limits<double>::infinity());
};
Rectangle join(const Rectangle&, const Rectangle&);
inline bool overlap(const Rectangle& a, const Rectangle& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}
Rectangle bounds(const CurvePiece&);

CurvePiece line_piece(const Vec2& from, const Vec2& to);
/// A quadratic Bezier curve, as in fonts.
CurvePiece conic_piece(const Vec2& from, const Vec2& control, const Vec2& to);

/// Minimum number of points of a curve of the kind.
std::size_t min_points(CurveKind);

/// Returns the pieces of one curve. Precondition: at least min_points() points, and a multiple of
/// four for bezier_curve.
std::vector<CurvePiece> curve(CurveKind, std::span<const Vec2> points);

/// The pieces of several consecutive closed curves. A curve ends where it returns to its first
/// point, and the next one begins with the following point. An open linear loop is closed.
struct Loops {
    std::vector<std::vector<CurvePiece>> loops;
    bool closed = true;  ///< false: the last loop does not return to its start
};
Loops closed_curves(CurveKind, std::span<const Vec2> points);

}  // namespace candelabra
