// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/pavement.h"

#include "pattern/pavement_tables.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

const ItemInfo Pavement::vocabulary = described<Pavement>([] {
    using F = Field<Pavement>;
    return schema<Pavement>(
        "pavement",
        {"Tiles of several equal polygons in the x-z plane, 1 at their borders.",
         "pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 7 rotate 90*x scale 0.3 }",
         "pigment { pavement number_of_sides 6 number_of_tiles 4 pattern 3 exterior 0 interior 2 "
         "form 2 rotate 90*x scale 0.2 }"},
        F{"number_of_sides", &Pavement::number_of_sides, item,
          "polygons: 3 triangles, 4 squares, 6 hexagons"},
        F{"number_of_tiles", &Pavement::number_of_tiles, item,
          "polygons of a tile: from 1 to 6, and to 5 for hexagons"},
        F{"pattern", &Pavement::pattern, item,
          "from 1 on: triangles have 1, 1, 1, 3, 4, 12 patterns by number of tiles, squares "
          "1, 1, 2, 5, 12, 35, and hexagons 1, 1, 3, 7, 22"},
        F{"exterior", &Pavement::exterior, item,
          "corners of 60 and 90 degrees: 0 sharp, 1 cut off, 2 round"},
        F{"interior", &Pavement::interior, item,
          "corners above 180 degrees: 0 sharp, 1 cut off, 2 round"},
        F{"form", &Pavement::form, item,
          "corners of 120 degrees, and bends of squares: 0 sharp, 1 cut off, 2 round; 3, for "
          "squares: as exterior and interior"});
});

namespace {

using std::numbers::sqrt3;

constexpr int patterns_of_triangles[] = {1, 1, 1, 3, 4, 12};
constexpr int patterns_of_squares[] = {1, 1, 2, 5, 12, 35};
constexpr int patterns_of_hexagons[] = {1, 1, 3, 7, 22};

/// How a corner looks. Bends of squares may also look as other corners do.
enum class Look { sharp, cut, round, as_corners };

/// Numbers from `count` on begin again. Only the lowest byte counts, as in POV-Ray.
Look look_of(int number, int count) {
    return static_cast<Look>(static_cast<unsigned char>(number) % count);
}

/// The looks of the corners of a pavement.
struct Looks {
    Look exterior, interior, form;
};

/// A vertex of the lattice, and a point in the sector between two neighbouring edges there: its
/// coordinates along the first and the second edge. Edges are numbered anticlockwise.
struct LatticeCorner {
    int x, y;
    int sector;
    double u, v;
};

struct LatticeStep {
    int x, y;
};

constexpr LatticeStep square_steps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
constexpr LatticeStep triangle_steps[] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};

/// Which edges of the lattice are borders.
class Borders {
public:
    Borders(const BorderTable& table, std::span<const LatticeStep> steps)
        : table_(table), steps_(steps), edges_(static_cast<int>(steps.size())) {}

    /// Whether an edge at the corner's vertex is a border: the first of its sector, or a later one.
    bool contains(const LatticeCorner& corner, int later) const {
        int edge = (corner.sector + later) % edges_, x = corner.x, y = corner.y;
        if (edge >= edges_ / 2) {
            const LatticeStep& back = steps_[static_cast<std::size_t>(edge)];
            edge -= edges_ / 2;
            x += back.x;
            y += back.y;
        }
        const int rows = table_.rows();
        const int repeats = (y < 0 ? y - rows + 1 : y) / rows;
        const int column = (x - repeats * table_.shift) % table_.width;
        const int place =
            (y - repeats * rows) * table_.width + (column < 0 ? column + table_.width : column);
        const int digit = table_.borders[static_cast<std::size_t>(place)] - '0';
        return (digit >> edge & 1) != 0;
    }

    bool touch(const LatticeCorner& corner) const {
        for (int later = 0; later < edges_; ++later)
            if (contains(corner, later)) return true;
        return false;
    }

private:
    const BorderTable& table_;
    std::span<const LatticeStep> steps_;
    int edges_;
};

/// Returns the corner at the end of the first edge, in the same square.
LatticeCorner next_in_square(const LatticeCorner& at) {
    const LatticeStep& step = square_steps[at.sector];
    return {at.x + step.x, at.y + step.y, (at.sector + 1) % 4, at.v, 1 - at.u};
}

/// Whether the tile bends by a right angle in the corner's square, and the corner is outside.
bool is_bend(const Borders& borders, const LatticeCorner& at) {
    const LatticeCorner inner = next_in_square(next_in_square(at));
    return borders.contains(at, 0) && borders.contains(at, 1) && !borders.contains(inner, 0) &&
           !borders.contains(inner, 1) && borders.touch(inner);
}

/// The value where a tile bends: a diagonal or an arc from side to side is 0.
double value_in_bend(Look form, const LatticeCorner& at) {
    const Vec2 offset(2 - 2 * at.u, 2 - 2 * at.v);
    const double across = form == Look::cut ? offset.x + offset.y : length(offset);
    return std::min(1.0, std::abs(across - 1));
}

/// The value in a quarter of a square, at a corner of its tile.
double value_at_exterior(Look exterior, double u, double v) {
    switch (exterior) {
        case Look::cut:
            return std::min(1.0, 2 - 2 * (u + v));
        case Look::round:
            return std::min(1.0, length(Vec2(1 - 2 * u, 1 - 2 * v)));
        default:
            return 1 - 2 * std::min(u, v);
    }
}

/// The value in a quarter of a square that touches a border with its corner alone.
double value_at_interior(Look interior, double u, double v) {
    const double distance = interior == Look::cut     ? u + v
                            : interior == Look::round ? length(Vec2(u, v))
                                                      : std::max(u, v);
    return std::max(0.0, 1 - 2 * distance);
}

double value_in_square(const Borders& borders, const Looks& looks, const Vec2& p) {
    const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
    LatticeCorner at{x, y, 0, p.x - x, p.y - y};
    Look exterior = looks.exterior, interior = looks.interior;
    for (int i = 0; i < 4; ++i, at = next_in_square(at)) {
        if (looks.form == Look::as_corners || !is_bend(borders, at)) continue;
        if (looks.form != Look::sharp) return value_in_bend(looks.form, at);
        exterior = interior = Look::sharp;
    }
    while (std::max(at.u, at.v) > 0.5) at = next_in_square(at);
    const bool first = borders.contains(at, 0), second = borders.contains(at, 1);
    if (first && second) return value_at_exterior(exterior, at.u, at.v);
    if (first || second) return 1 - 2 * (first ? at.v : at.u);
    return borders.touch(at) ? value_at_interior(interior, at.u, at.v) : 0;
}

/// Returns the corner of the triangle that is nearest to the point.
LatticeCorner corner_of_triangle(const Vec2& p) {
    const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
    const double u = p.x - x, v = p.y - y, w = 1 - u - v;
    if (w > 0) {
        if (w >= std::max(u, v)) return {x, y, 0, u, v};
        return u >= v ? LatticeCorner{x + 1, y, 2, v, w} : LatticeCorner{x, y + 1, 4, w, u};
    }
    if (-w >= std::max(1 - u, 1 - v)) return {x + 1, y + 1, 3, 1 - u, 1 - v};
    return v >= u ? LatticeCorner{x, y + 1, 5, 1 - v, -w} : LatticeCorner{x + 1, y, 1, -w, 1 - u};
}

/// Length of a vector with these coordinates along two edges at 60 degrees.
double oblique_length(double u, double v) { return std::sqrt(u * u + u * v + v * v); }

/// The value at a corner of 60 degrees.
double value_between(Look exterior, double u, double v) {
    const double sharp = 1 - 3 * std::min(u, v);
    switch (exterior) {
        case Look::cut:
            return std::max(sharp, 2 - 3 * (u + v));
        case Look::round:
            return 2 * sqrt3 * oblique_length(u - 1.0 / 3, v - 1.0 / 3);
        default:
            return sharp;
    }
}

/// The value in half of a corner of 120 degrees, by the coordinates off its border and along it.
double value_in_half(Look form, double off, double along) {
    switch (form) {
        case Look::cut:
            return 2 - 4 * off - 2 * along;
        case Look::round:
            return 2 * sqrt3 * oblique_length(off - 1, along) - 2;
        default:
            return 1 - 3 * off;
    }
}

/// The value in a triangle that touches a border with its corner alone.
double value_around(Look interior, double u, double v) {
    switch (interior) {
        case Look::cut:
            return 1 - 3 * std::max(u + v / 2, u / 2 + v);
        case Look::round:
            return 1 - 3 * oblique_length(u, v);
        default:
            return 1 - 3 * (u + v);
    }
}

double value_in_triangle(const Borders& borders, const Looks& looks, const Vec2& p) {
    const LatticeCorner at = corner_of_triangle(p);
    const bool first = borders.contains(at, 0), second = borders.contains(at, 1);
    double value = 0;
    if (first && second)
        value = value_between(looks.exterior, at.u, at.v);
    else if (first)
        value = value_in_half(borders.contains(at, 2) ? looks.form : Look::sharp, at.v, at.u);
    else if (second)
        value = value_in_half(borders.contains(at, 5) ? looks.form : Look::sharp, at.u, at.v);
    else if (borders.touch(at))
        value = value_around(looks.interior, at.u, at.v);
    return std::clamp(value, 0.0, 1.0);
}

/// Moves a position in the lattice by periods to coordinates that are not negative and that an int
/// can hold.
Vec2 folded(const BorderTable& table, const Vec2& p) {
    const int width = table.width, height = table.width * table.rows();
    const Vec2 rest(std::fmod(p.x, width), std::fmod(p.y, height));
    return {rest.x < 0 ? rest.x + width : rest.x, rest.y < 0 ? rest.y + height : rest.y};
}

}  // namespace

std::span<const int> pavement_patterns(int number_of_sides) {
    switch (number_of_sides) {
        case 3:
            return patterns_of_triangles;
        case 4:
            return patterns_of_squares;
        case 6:
            return patterns_of_hexagons;
        default:
            return {};
    }
}

double evaluate(const Pavement& pavement, const Vec3& point) {
    const bool squares = pavement.number_of_sides == 4;
    const double row = squares ? point.z : point.z * 2 / sqrt3;
    const Vec2 place(squares ? point.x : point.x - row / 2, row);
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return 0;
    int before = 0;
    for (const int count : pavement_patterns(pavement.number_of_sides)
                               .first(static_cast<std::size_t>(pavement.number_of_tiles - 1)))
        before += count;
    const BorderTable& table = border_tables(
        pavement.number_of_sides)[static_cast<std::size_t>(before + pavement.pattern - 1)];
    const Looks looks{look_of(pavement.exterior, 3), look_of(pavement.interior, 3),
                      look_of(pavement.form, squares ? 4 : 3)};
    const Vec2 home = folded(table, place);
    return squares ? value_in_square(Borders(table, square_steps), looks, home)
                   : value_in_triangle(Borders(table, triangle_steps), looks, home);
}

}  // namespace candelabra
