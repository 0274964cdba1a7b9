// SPDX-License-Identifier: GPL-3.0-or-later
// A tile is found from above. Ten large halves of tiles surround the origin. Each half is divided
// into smaller halves, and the one with the point is divided again, until the tiles have their
// size. This takes a time that is logarithmic in the distance from the origin. (Grünbaum and
// Shephard, Tilings and Patterns, chapter 10.)
#include "pattern/penrose.h"

#include "base/circle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace candelabra {
namespace {

using std::numbers::phi;

/// Half of a tile. Kites and darts (large and small) are cut along their axis from `a`, the tip, to
/// `c`; `b` is the corner beside it. Rhombs (thick and thin) are cut along the diagonal from `b` to
/// `c`. By the rules of matching their sides from `a` to `b` are of a first kind, and those from
/// `a` to `c` of a second one.
struct HalfTile {
    bool large;
    Vec2 a, b, c;
};

/// Area of the parallelogram of two vectors, above 0 if the second is to the left of the first.
double signed_area(const Vec2& u, const Vec2& v) { return u.x * v.y - u.y * v.x; }

/// Returns the direction after this number of tenths of a turn from +x.
Vec2 tenth(int count) {
    static const std::array<Vec2, 10> all = [] {
        std::array<Vec2, 10> directions;
        for (int i = 0; i < 10; ++i)
            directions[std::size_t(i)] = on_circle(i * std::numbers::pi / 5);
        return directions;
    }();
    return all[std::size_t(count % 10)];
}

/// Returns the least of the point's barycentric coordinates: below 0 outside.
double inside(const HalfTile& half, const Vec2& point) {
    const Vec2 a = half.a - point, b = half.b - point, c = half.c - point;
    const double share = 1 / signed_area(half.b - half.a, half.c - half.a);
    return std::min(
        {signed_area(a, b) * share, signed_area(b, c) * share, signed_area(c, a) * share});
}

struct Parts {
    std::array<HalfTile, 3> halves;
    std::size_t count;

    const HalfTile* begin() const { return halves.data(); }
    const HalfTile* end() const { return halves.data() + count; }
};

Vec2 golden(const Vec2& from, const Vec2& to) { return from + (to - from) / phi; }

Parts divide_kite(const HalfTile& half) {
    const auto& [kite, a, b, c] = half;
    if (!kite) {
        const Vec2 p = golden(a, b);
        return {{{{true, a, p, c}, {false, b, c, p}, {}}}, 2};
    }
    const Vec2 p = golden(b, a), q = golden(a, c);
    return {{{{false, a, q, p}, {true, b, p, q}, {true, b, c, q}}}, 3};
}

Parts divide_rhomb(const HalfTile& half) {
    const auto& [thick, a, b, c] = half;
    if (!thick) {
        const Vec2 p = golden(a, b);
        return {{{{false, c, p, b}, {true, p, c, a}, {}}}, 2};
    }
    const Vec2 q = golden(b, a), r = golden(b, c);
    return {{{{true, r, c, a}, {true, q, r, b}, {false, r, q, a}}}, 3};
}

/// One of the tilings, from the halves around the origin downwards.
struct Descent {
    Parts (*divide)(const HalfTile&);
    HalfTile (*half)(double side, const Vec2& axis, const Vec2& beside);
    double side;

    /// Calls `visit(half, levels)` for the halves around the origin that hold the points up to this
    /// distance, and that are divided so many times.
    void start(double distance, auto&& visit) const {
        double size = side;
        int levels = 0;
        // Two divisions turn the tiling around the origin by half a turn.
        for (; 0.9 * size < distance + 1; size *= phi * phi) levels += 2;
        const int turn = levels % 4 == 0 ? 0 : 5;
        for (int arm = turn; arm < turn + 10; arm += 2)
            for (const int beside : {1, 9})
                visit(half(size, tenth(arm), tenth(arm + beside)), levels);
    }
};

HalfTile half_of_sun(double side, const Vec2& axis, const Vec2& beside) {
    return {true, Vec2(0), side * beside, side * axis};
}
/// Returns half of one of five thick rhombs that meet with sides of the second kind.
HalfTile half_of_star(double side, const Vec2& axis, const Vec2& beside) {
    return {true, -side * beside, -phi * side * axis, Vec2(0)};
}
/// Returns half of one of five thick rhombs that meet with sides of the first kind.
HalfTile half_of_other_star(double side, const Vec2& axis, const Vec2& beside) {
    return {true, -side * beside, Vec2(0), -phi * side * axis};
}

HalfTile half_at(const Descent& descent, const Vec2& point) {
    HalfTile best{};
    double deepest = -std::numeric_limits<double>::infinity();
    int remaining = 0;
    const auto compare = [&](const HalfTile& half) {
        if (deepest >= 0) return;
        const double depth = inside(half, point);
        if (depth <= deepest) return;
        deepest = depth;
        best = half;
    };
    descent.start(glm::length(point), [&](const HalfTile& half, int levels) {
        remaining = levels;
        compare(half);
    });
    for (; remaining > 0; --remaining) {
        deepest = -std::numeric_limits<double>::infinity();
        for (const HalfTile& part : descent.divide(best)) compare(part);
    }
    return best;
}

/// Returns the value of the kind with this number, from 0, at a depth below the border of its tile.
double shade(int kind, double parts, double fall) {
    return std::max(kind / parts + (kind > 0 ? 1e-6 : 0), (kind + 1) / parts - fall);
}

double distance_to_line(const Vec2& point, const Vec2& a, const Vec2& b) {
    return std::abs(signed_area(b - a, point - a)) / glm::length(b - a);
}

/// Returns the point itself, unless it is so far away that rounding would mix up the tiles: such
/// points count as the origin.
Vec2 defined(const Vec2& point) {
    constexpr double far = 1e13;
    return std::abs(point.x) < far && std::abs(point.y) < far ? point : Vec2(0);
}

// How fast values fall from the border of a tile, measured in POV-Ray's pictures.
constexpr double kite_slope = 2.23;
constexpr double rhomb_slope = 1.7150443;
constexpr double pentagon_slope = rhomb_slope / 3;

/// The pentagons have their centres at corners of rhombs. Sides of the first kind connect the
/// centres of pentagons that share a side. Sides of the second kind are inside of the gaps, and
/// meet at the middle of each gap.
struct Pentagons {
    double radius = 0.5 / math::tan(std::numbers::pi / 5);  // of the inscribed circle
    Descent descent{divide_rhomb, half_of_other_star, 2 * radius};
    std::array<Vec2, 5> turns{tenth(0), tenth(2), tenth(4), tenth(6), tenth(8)};

    /// Distance of a point from the side of a pentagon that faces in a direction; above 0 outside.
    double outside(const Vec2& point, const Vec2& centre, const Vec2& facing) const {
        return dot(point - centre, facing) - radius;
    }
};

Vec2 rotated(const Vec2& vector, const Vec2& turn) {
    return {vector.x * turn.x - vector.y * turn.y, vector.x * turn.y + vector.y * turn.x};
}

/// Calls `visit` for the halves within a larger one that touch a corner, and for few others.
void find_around(const Descent& descent, const HalfTile& half, int levels, const Vec2& corner,
                 const auto& visit) {
    // Much more than rounding, and much less than the tiles that touch no corner.
    if (inside(half, corner) < -0.01) return;
    if (levels == 0) {
        visit(half);
        return;
    }
    for (const HalfTile& part : descent.divide(half))
        find_around(descent, part, levels - 1, corner, visit);
}

void visit_around(const Descent& descent, const Vec2& corner, const auto& visit) {
    descent.start(glm::length(corner), [&](const HalfTile& half, int levels) {
        find_around(descent, half, levels, corner, visit);
    });
}

bool meets(const Vec2& a, const Vec2& b) { return glm::length(a - b) < 0.1; }

/// Returns the kind of the pentagon around a corner, by the number of its neighbours.
int kind_of_pentagon(const Descent& descent, const Vec2& corner) {
    int sides = 0;  // each is one of two rhombs
    visit_around(descent, corner, [&](const HalfTile& half) {
        if (meets(half.a, corner) || meets(half.b, corner)) ++sides;
    });
    return sides >= 10 ? 0 : sides >= 6 ? 2 : 1;
}

/// Returns the value in the gap with a half of a rhomb. Around the middle of a star are five thick
/// rhombs, of a boat three and a thin one, of a narrow rhomb one and two thin ones.
double shade_gap(const Pentagons& pentagons, const HalfTile& half, const Vec2& point) {
    int thick = 0;
    Vec2 to_thick(1, 0), to_thin(1, 0);
    visit_around(pentagons.descent, half.c, [&](const HalfTile& other) {
        if (!meets(other.c, half.c)) return;
        (other.large ? to_thick : to_thin) = normalize(other.b - other.c);
        thick += other.large ? 1 : 0;
    });
    const bool left = signed_area(half.b - half.a, half.c - half.a) > 0;
    const Vec2 facing =
        rotated((half.b - half.a) / (2 * pentagons.radius), pentagons.turns[left ? 1 : 4]);
    const double own = pentagons.outside(point, half.a, facing);
    if (thick >= 10) return shade(3, 6, pentagon_slope * own);

    const double side = 2 * pentagons.radius;
    const Vec2 axis = thick == 6 ? to_thin : to_thick, offset = point - half.c;
    const Vec2 folded(dot(offset, axis), std::abs(signed_area(axis, offset)));
    if (thick == 6) {
        const double end = pentagons.outside(folded, {side / phi, 0}, {-1, 0});
        return shade(4, 6, pentagon_slope * (half.large ? std::min(own, end) : end));
    }
    const double first = pentagons.outside(folded, side * tenth(1), tenth(7));
    const double second = pentagons.outside(folded, side / phi * tenth(3), tenth(8));
    return shade(5, 6, pentagon_slope * std::min(first, second));
}

}  // namespace

double penrose_pentagons(const Vec2& place) {
    static const Pentagons pentagons;
    const Vec2 point = defined(place);
    const HalfTile half = half_at(pentagons.descent, point);
    const bool first = glm::length(point - half.a) < glm::length(point - half.b);
    const Vec2 centre = first ? half.a : half.b;
    const Vec2 facing = ((first ? half.b : half.a) - centre) / (2 * pentagons.radius);
    double outside = -std::numeric_limits<double>::infinity();
    for (const Vec2& turn : pentagons.turns)
        outside = std::max(outside, pentagons.outside(point, centre, rotated(facing, turn)));
    if (outside > 0) return shade_gap(pentagons, half, point);
    return shade(kind_of_pentagon(pentagons.descent, centre), 6, -pentagon_slope * outside);
}

double penrose_kites(const Vec2& place) {
    const Vec2 point = defined(place);
    const auto [kite, a, b, c] = half_at({divide_kite, half_of_sun, 1}, point);
    const double depth = std::min(distance_to_line(point, a, b), distance_to_line(point, b, c));
    return shade(kite ? 0 : 1, 2, kite_slope * depth);
}

double penrose_rhombs(const Vec2& place) {
    const Vec2 point = defined(place);
    const auto [thick, a, b, c] = half_at({divide_rhomb, half_of_star, 1}, point);
    const double depth = std::min(distance_to_line(point, a, b), distance_to_line(point, a, c));
    return shade(thick ? 0 : 1, 2, rhomb_slope * depth);
}

}  // namespace candelabra
