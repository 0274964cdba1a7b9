// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/curve.h"

namespace candelabra {

namespace {

/// Distance below which loops treat points as equal.
constexpr double same = 1e-10;

bool equal(const Vec2& a, const Vec2& b) {
    return std::abs(a.x - b.x) < same && std::abs(a.y - b.y) < same;
}

/// From b to c; a shapes it.
CurvePiece quadratic_piece(const Vec2& a, const Vec2& b, const Vec2& c) {
    return {{b, 0.5 * (c - a), 0.5 * (a - 2.0 * b + c), Vec2(0)}, b, c};
}

/// From b to c; a and d shape it.
CurvePiece cubic_piece(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return {
        {b, 0.5 * (c - a), a - 2.5 * b + 2.0 * c - 0.5 * d, 0.5 * (d - a) + 1.5 * (b - c)}, b, c};
}

CurvePiece bezier_piece(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return {{a, 3.0 * (b - a), 3.0 * (a - 2.0 * b + c), d - a + 3.0 * (b - c)}, a, d};
}

/// The piece that begins with the control point i.
CurvePiece piece(CurveKind kind, std::span<const Vec2> p, std::size_t i) {
    switch (kind) {
        case linear_curve:
            return line_piece(p[i], p[i + 1]);
        case quadratic_curve:
            return quadratic_piece(p[i], p[i + 1], p[i + 2]);
        case cubic_curve:
            return cubic_piece(p[i], p[i + 1], p[i + 2], p[i + 3]);
        case bezier_curve:
            break;
    }
    return bezier_piece(p[i], p[i + 1], p[i + 2], p[i + 3]);
}

/// Number of control points of a piece, and the number that the next piece advances by.
std::size_t used(CurveKind kind) {
    return kind == linear_curve ? 2 : kind == quadratic_curve ? 3 : 4;
}
std::size_t step(CurveKind kind) { return kind == bezier_curve ? 4 : 1; }

}  // namespace

std::array<double, 4> CurvePiece::combined(const Vec2& weights, double constant) const {
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i)
        result[i] = weights.x * factors[i].x + weights.y * factors[i].y;
    result[0] += constant;
    return result;
}

Rectangle join(const Rectangle& a, const Rectangle& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

Rectangle bounds(const CurvePiece& piece) {
    Rectangle box{glm::min(piece.start, piece.end), glm::max(piece.start, piece.end)};
    for (int axis = 0; axis < 2; ++axis) {
        const std::array<double, 3> slope = {piece.factors[1][axis], 2 * piece.factors[2][axis],
                                             3 * piece.factors[3][axis]};
        for (const double u : sign_changes(slope, {0, 1})) {
            const double turn = piece.at(u)[axis];
            box.low[axis] = std::fmin(box.low[axis], turn);
            box.high[axis] = std::fmax(box.high[axis], turn);
        }
    }
    return box;
}

CurvePiece line_piece(const Vec2& from, const Vec2& to) {
    return {{from, to - from, Vec2(0), Vec2(0)}, from, to};
}

CurvePiece conic_piece(const Vec2& from, const Vec2& control, const Vec2& to) {
    return {{from, 2.0 * (control - from), from - 2.0 * control + to, Vec2(0)}, from, to};
}

std::size_t min_points(CurveKind kind) { return used(kind); }

std::vector<CurvePiece> curve(CurveKind kind, std::span<const Vec2> points) {
    std::vector<CurvePiece> pieces;
    for (std::size_t i = 0; i + used(kind) <= points.size(); i += step(kind))
        pieces.push_back(piece(kind, points, i));
    return pieces;
}

Loops closed_curves(CurveKind kind, std::span<const Vec2> points) {
    Loops result;
    std::vector<CurvePiece> loop;
    for (std::size_t i = 0; i + used(kind) <= points.size();) {
        loop.push_back(piece(kind, points, i));
        CurvePiece& last = loop.back();
        const bool back = equal(last.end, loop.front().start);
        i += step(kind);
        if (!back) continue;
        last.end = loop.front().start;
        result.loops.push_back(std::move(loop));
        loop.clear();
        // The remaining control points belong to this loop.
        if (kind != bezier_curve) i += used(kind) - 1;
    }
    if (loop.empty()) return result;
    result.closed = kind == linear_curve;
    loop.push_back(line_piece(loop.back().end, loop.front().start));
    result.loops.push_back(std::move(loop));
    return result;
}

}  // namespace candelabra
