// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/tiling.h"

#include "base/circle.h"
#include "base/degrees.h"
#include "base/elementary.h"
#include "pattern/penrose.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <initializer_list>
#include <numbers>

namespace candelabra {

const ItemInfo Tiling::vocabulary = described<Tiling>([] {
    using F = Field<Tiling>;
    return schema<Tiling>(
        "tiling",
        {"Tiles in the x-z plane: columns along y, shaded towards their borders.",
         "pigment { tiling 8 rotate 90*x scale 0.25 }",
         "pigment { tiling 16 rotate 90*x scale 0.2 }",
         "pigment { tiling 24 rotate 90*x scale 0.2 }",
         "pigment { tiling 25 rotate 90*x scale 0.25 }",
         "pigment { tiling 26 rotate 90*x scale 0.3 }",
         "pigment { tiling 27 rotate 90*x scale 0.3 }"},
        F{"type", &Tiling::type, positional,
          "1 squares, 2 hexagons, 3 triangles, 4 and 5 rhombi, 6 dominoes, 7 octagons and "
          "squares ... 24 dodecagons, hexagons and squares, 25 to 27 Penrose's tilings: "
          "pentagons, kites and darts, rhombs",
          between(1, 27)});
});

namespace {

using std::numbers::sqrt2;
using std::numbers::sqrt3;

constexpr double h = sqrt3 / 2;      // height of an equilateral triangle with side 1
constexpr double steep = 2 * sqrt3;  // falls by 1 from the centre of such a triangle to a side
constexpr double none = -1e9;

/// A border of a tile: its half-plane, and the slope at which the value falls towards it.
struct Border {
    Vec2 inward;
    double offset;
    double slope;

    double distance(const Vec2& p) const { return dot(p, inward) - offset; }
};

/// The value is `top` minus the fall towards the nearest border, but at least `low`.
struct Values {
    double top;
    double slope;
    double low = none;
};

struct Tile {
    std::vector<Border> borders;
    Values values;

    double inside(const Vec2& p) const {
        double least = borders.front().distance(p);
        for (const Border& border : borders) least = std::min(least, border.distance(p));
        return least;
    }
    double value(const Vec2& p) const {
        double fall = std::numeric_limits<double>::infinity();
        for (const Border& border : borders)
            fall = std::min(fall, border.slope * border.distance(p));
        return std::max(values.low, values.top - fall);
    }
};

Vec2 direction(double degrees) { return on_circle(degrees * radians_per_degree); }

/// Apothem of a regular polygon with sides of length 1.
double apothem(int sides) { return 0.5 / math::tan(std::numbers::pi / sides); }

/// Returns a regular polygon with sides of length 1, one of which faces the direction in degrees.
Tile regular(int sides, const Vec2& centre, double facing, Values values) {
    Tile tile{{}, values};
    for (int i = 0; i < sides; ++i) {
        const Vec2 outward = direction(facing + 360.0 * i / sides);
        tile.borders.push_back({-outward, -dot(centre, outward) - apothem(sides), values.slope});
    }
    return tile;
}

Tile rectangle(const Vec2& corner, const Vec2& size, Values values) {
    const Vec2 end = corner + size;
    return {{{Vec2(1, 0), corner.x, values.slope},
             {Vec2(-1, 0), -end.x, values.slope},
             {Vec2(0, 1), corner.y, values.slope},
             {Vec2(0, -1), -end.y, values.slope}},
            values};
}

/// Returns a rhombus with sides of length 1, from the origin along two directions in degrees; the
/// second is to the left of the first.
Tile rhombus(double first, double second, Values values) {
    const Vec2 a = direction(first), b = direction(second);
    const Vec2 left(-a.y, a.x), right(b.y, -b.x);
    return {{{left, 0, values.slope},
             {-left, -dot(b, left), values.slope},
             {right, 0, values.slope},
             {-right, -dot(a, right), values.slope}},
            values};
}

Tile up(double x, double z, Values values) { return regular(3, {x, z + h / 3}, 270, values); }
Tile down(double x, double z, Values values) { return regular(3, {x, z + 2 * h / 3}, 90, values); }

/// Tiles that repeat along two vectors. The values are divided by `parts`.
struct Arrangement {
    Vec2 first, second;
    double parts;
    std::vector<Tile> tiles;

    double value(const Vec2& point) const {
        const double area = first.x * second.y - first.y * second.x;
        const Vec2 shift = std::floor((point.x * second.y - point.y * second.x) / area) * first +
                           std::floor((first.x * point.y - first.y * point.x) / area) * second;
        const Vec2 home = point - shift;
        const Tile* best = nullptr;
        Vec2 place(0);
        double deepest = -std::numeric_limits<double>::infinity();
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j) {
                const Vec2 at = home + double(i) * first + double(j) * second;
                for (const Tile& tile : tiles) {
                    const double inside = tile.inside(at);
                    if (best && inside <= deepest) continue;
                    deepest = inside;
                    best = &tile;
                    place = at;
                }
            }
        return std::max(0.0, best->value(place)) / parts;
    }
};

Arrangement rectangles(double period, double parts, double slope,
                       std::initializer_list<std::pair<Vec2, Vec2>> corners_and_sizes,
                       std::initializer_list<double> tops) {
    Arrangement result{{period, 0}, {0, period}, parts, {}};
    auto top = tops.begin();
    for (const auto& [corner, size] : corners_and_sizes)
        result.tiles.push_back(rectangle(corner, size, {*top++, slope}));
    return result;
}

/// Returns hexagons around every seventh vertex of the triangular grid, and the triangles that
/// touch none. Vertex (i, j) has number i + `count` j modulo 7; the vertices with number `centre`
/// are the centres of hexagons.
Arrangement hexagons_in_triangles(const Vec2& first, const Vec2& second, int centre, int count) {
    Arrangement result{first, second, 3, {}};
    result.tiles.push_back(regular(6, {double(centre), 0}, 30, {3, steep, 2.000001}));
    const auto touches = [&](int vertex) { return ((vertex - centre) % 7 + 7) % 7 == 0; };
    for (int i = 0; i < 7; ++i) {
        if (!touches(i) && !touches(i + 1) && !touches(i + count))
            result.tiles.push_back(up(i + 0.5, 0, {1, steep}));
        if (!touches(i + 1) && !touches(i + count) && !touches(i + 1 + count))
            result.tiles.push_back(down(i + 1, 0, {2, steep}));
    }
    return result;
}

/// Adds a polygon on the side of another in each of the directions.
void add_around(Arrangement& arrangement, const Vec2& centre, int inner_sides, int sides,
                std::initializer_list<std::pair<double, Values>> around) {
    for (const auto& [facing, values] : around)
        arrangement.tiles.push_back(
            regular(sides, centre + (apothem(inner_sides) + apothem(sides)) * direction(facing),
                    facing + 180, values));
}

Arrangement hexagons_and_squares(double parts, Values hexagon, std::array<Values, 3> squares,
                                 std::array<Values, 2> triangles) {
    const Vec2 centre(0.5 + h, 0.5 + h);
    Arrangement result{{1.5 + h, (1 + sqrt3) / 2}, {0, 1 + sqrt3}, parts, {}};
    result.tiles.push_back(regular(6, centre, 30, hexagon));
    add_around(result, centre, 6, 4, {{90, squares[0]}, {30, squares[1]}, {150, squares[2]}});
    // Triangles share only corners with the hexagon.
    const double away = 1 + 2 * apothem(3);
    result.tiles.push_back(regular(3, centre + away * direction(0), 0, triangles[0]));
    result.tiles.push_back(regular(3, centre + away * direction(60), 60, triangles[1]));
    return result;
}

Arrangement snub_squares() {
    const double a = (1 + sqrt3) / 2;
    Arrangement result{{a, a}, {a, -a}, 6, {}};
    result.tiles = {regular(4, {0.5 * a, 0.5 * a}, 60, {5, steep, 4.000001}),
                    regular(4, {1.5 * a, 0.5 * a}, 120, {6, steep, 5.000001}),
                    regular(3, {h / 3, 0}, 180, {1, steep}),
                    regular(3, {a, -h / 3}, 90, {2, steep}),
                    regular(3, {-h / 3, 0}, 0, {3, steep}),
                    regular(3, {a, h / 3}, 270, {4, steep})};
    return result;
}

Arrangement dodecagons_and_triangles() {
    const Vec2 centre(1 + h, 1 + h);
    Arrangement result{{2 + sqrt3, 0}, {1 + h, 1.5 + sqrt3}, 3, {}};
    Tile dodecagon = regular(12, centre, 0, {3.0000001, steep, 2.0000001});
    for (const std::size_t side : {0, 6, 9}) dodecagon.borders[side].slope = 3;
    result.tiles.push_back(std::move(dodecagon));
    add_around(result, centre, 12, 3, {{90, {1, steep, 0}}, {30, {2, steep, 1}}});
    return result;
}

Arrangement dodecagons_and_hexagons(double parts, std::array<double, 3> squares) {
    const Vec2 centre(1.5 + h, 1 + sqrt3);
    Arrangement result{{3 + sqrt3, 0}, {1.5 + h, 1.5 + 3 * h}, parts, {}};
    result.tiles.push_back(regular(12, centre, 0, {parts + 0.000001, 2, parts - 1 + 0.000001}));
    add_around(result, centre, 12, 4,
               {{0, {squares[0], 2}}, {60, {squares[1], 2}}, {120, {squares[2], 2}}});
    add_around(result, centre, 12, 6, {{30, {1, 2, 0}}, {90, {1, 2, 0}}});
    return result;
}

constexpr Vec2 flat(2, 1), tall(1, 2), small(1, 1), large(2, 2);
constexpr Vec2 hexagon_step(1.5, h);

Arrangement squares_and_octagons() {
    const double period = sqrt2 + 1;
    return {{period, 0},
            {0, period},
            1,
            {regular(8, {0, 0}, 0, {1, 1, 0.500000000001}),
             regular(4, {period / 2, period / 2}, 45, {0.5, 1})}};
}

Arrangement two_sizes_of_squares() {
    Arrangement result = rectangles(
        5, 2, 2,
        {{{0, 0}, small}, {{2, 1}, small}, {{4, 2}, small}, {{1, 3}, small}, {{3, 4}, small}},
        {1, 1, 1, 1, 1});
    for (const Vec2& centre : {Vec2(2, 0), Vec2(4, 1), Vec2(1, 2), Vec2(3, 3), Vec2(0, 4)})
        result.tiles.push_back(rectangle(centre - Vec2(1), large, {2.00000002, 2, 1.00000002}));
    return result;
}

Arrangement pinwheel() {
    return rectangles(
        3, 3, 2, {{{0, 0}, tall}, {{2, 1}, tall}, {{1, 0}, flat}, {{0, 2}, flat}, {{1, 1}, small}},
        {3, 3, 2, 2, 1});
}

/// Returns the arrangements by type, except 12 to 14, which are folded, and those
/// without period.
std::vector<Arrangement> make_arrangements() {
    const Vec2 centre(0.5, h);
    const Values third{1, steep}, second_third{2, steep};
    std::vector<Arrangement> all(25);
    all[1] = {{1, 0}, {0, 1}, 1, {regular(4, {0.5, 0.5}, 0, {1, 2})}};
    all[2] = {hexagon_step, {0, 2 * h}, 1, {regular(6, centre, 30, {1, 1 / h, 0})}};
    all[3] = {{1, 0}, {0.5, h}, 2, {up(0.5, 0, third), down(1, 0, second_third)}};
    all[4] = {{1, 0}, {0.5, h}, 1, {rhombus(0, 60, {1, 4 / sqrt3})}};
    all[5] = {hexagon_step,
              {0, 2 * h},
              3,
              {rhombus(0, 60, {1, 4 / sqrt3}), rhombus(60, 120, {2, 4 / sqrt3}),
               rhombus(120, 180, {3, 4 / sqrt3})}};
    all[6] = rectangles(4, 2, 2,
                        {{{0, 0}, tall},
                         {{1, 1}, tall},
                         {{2, 2}, tall},
                         {{3, -1}, tall},
                         {{1, 0}, flat},
                         {{2, 1}, flat},
                         {{-1, 2}, flat},
                         {{0, 3}, flat}},
                        {2, 2, 2, 2, 1, 1, 1, 1});
    all[7] = squares_and_octagons();
    all[8] = {{1, 0},
              {0.5, 1 + h},
              3,
              {regular(4, {0.5, 0.5}, 0, {3.0000001, steep, 2.0000001}), up(0.5, 1, third),
               down(1, 1, second_third)}};
    all[9] = {{2, 0},
              {1, 2 * h},
              3,
              {regular(6, centre, 30, {3, steep, 2.0000001}), up(1.5, 0, third),
               down(1.5, h, second_third)}};
    all[10] = {{1, 0}, {0.5, 1}, 1, {regular(4, {0.5, 0.5}, 0, {1, 2})}};
    all[11] = pinwheel();
    all[15] = two_sizes_of_squares();
    const Values square{1, steep, 0}, triangle{2, steep};
    all[16] = hexagons_and_squares(3, {3, steep, 2.0000001}, {square, square, square},
                                   {triangle, triangle});
    all[17] = hexagons_and_squares(
        6, {6, steep, 5.000001},
        {square, Values{2.000001, steep, 1.000001}, Values{3.000001, steep, 2.000001}},
        {Values{5, steep}, Values{4, steep}});
    all[18] = rectangles(4, 2, 2,
                         {{{0, 0}, tall},
                          {{1, 0}, tall},
                          {{2, 2}, tall},
                          {{3, 2}, tall},
                          {{2, 0}, flat},
                          {{2, 1}, flat},
                          {{0, 2}, flat},
                          {{0, 3}, flat}},
                         {2, 2, 2, 2, 1, 1, 1, 1});
    all[19] = hexagons_in_triangles({2.5, -h}, {4.5, h}, 6, 3);
    all[20] = hexagons_in_triangles({2.5, h}, {4.5, -h}, 3, -2);
    all[21] = snub_squares();
    all[22] = dodecagons_and_triangles();
    all[23] = dodecagons_and_hexagons(3, {2, 2, 2});
    all[24] = dodecagons_and_hexagons(5, {2, 3, 4});
    return all;
}

double arranged(int type, const Vec2& point) {
    static const std::vector<Arrangement> all = make_arrangements();
    return all[static_cast<std::size_t>(type)].value(point);
}

double modulo(double value, double divisor) {
    return value - divisor * std::floor(value / divisor);
}

/// Hexagons in pairs around a square, adjacent pairs at right angles. Type 14 distinguishes their
/// directions.
double crossed_hexagons(bool directions, const Vec2& point) {
    const double u = modulo(sqrt2 * point.x, 4) - 2, w = modulo(sqrt2 * point.y, 4) - 2;
    const double x = std::abs(u), z = std::abs(w);
    const double greater = std::max(x, z), less = std::min(x, z);
    if (greater < 1) {
        const double square = 2 * std::max(0.0, greater - 0.5);
        return directions ? (4.000001 + square) / 5 : square / 3;
    }
    double value = 2 * std::abs(1.5 - greater);
    if (less > 0.5) value = std::max(value, 1 - sqrt2 * std::abs(x - z));
    if (!directions) return (value + (x > z ? 2 : 1)) / 3;
    const int part = x > z ? (u < 0 ? 1 : 0) : (w < 0 ? 2 : 3);
    return (value + part) / 5;
}

}  // namespace

double evaluate(const Tiling& tiling, const Vec3& point) {
    const Vec2 p(point.x, point.z);
    switch (tiling.type) {
        case 12:
            return arranged(11, {std::abs(modulo(p.x, 6) - 3), std::abs(modulo(p.y, 6) - 3)});
        case 13:
        case 14:
            return crossed_hexagons(tiling.type == 14, p);
        case 25:
            return penrose_pentagons(p);
        case 26:
            return penrose_kites(p);
        case 27:
            return penrose_rhombs(p);
        default:
            return arranged(tiling.type, p);
    }
}

}  // namespace candelabra
