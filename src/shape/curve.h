// SPDX-License-Identifier: GPL-3.0-or-later
// Plane curves from control points, in pieces whose coordinates are cubic polynomials: what lathe,
// prism and text are swept from. The four kinds of splines have POV-Ray's meaning.
#pragma once

#include "base/roots.h"
#include "base/vector.h"

#include <vector>

namespace candelabra {

/// How a curve goes through its control points.
enum CurveKind : int {
    linear_curve,     ///< straight from point to point
    quadratic_curve,  ///< through all points but the first, which shapes the first piece
    cubic_curve,      ///< through all points but the first and the last (Catmull and Rom)
    bezier_curve,     ///< each four points are a piece: end, two controls, end
};

/// A piece of a curve: at(u) = factors[0] + factors[1] u + ... for u from 0 to 1.
struct CurvePiece {
    std::array<Vec2, 4> factors{};
    Vec2 start = Vec2(0);  ///< what at(0) and at(1) would be without rounding errors: neighbours
    Vec2 end = Vec2(0);    ///< share them

    Vec2 at(double u) const {
        return factors[0] + u * (factors[1] + u * (factors[2] + u * factors[3]));
    }
    Vec2 slope(double u) const { return factors[1] + u * (2.0 * factors[2] + 3 * u * factors[3]); }
    /// Factors of dot(weights, at(u)) + constant.
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
/// A Bezier curve of degree 2, as fonts have them.
CurvePiece conic_piece(const Vec2& from, const Vec2& control, const Vec2& to);

/// How many points a curve of the kind needs at least.
std::size_t min_points(CurveKind);

/// The pieces of one curve. Precondition: as many points as min_points() says, and a multiple of
/// four for bezier_curve.
std::vector<CurvePiece> curve(CurveKind, std::span<const Vec2> points);

/// The pieces of several closed curves in a row: each ends where it comes back to its first point,
/// and the next one begins with the point after that. A linear loop that stays open is closed.
struct Loops {
    std::vector<std::vector<CurvePiece>> loops;
    bool closed = true;  ///< false: the last loop does not come back to its start
};
Loops closed_curves(CurveKind, std::span<const Vec2> points);

}  // namespace candelabra
