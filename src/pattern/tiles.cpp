// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/tiles.h"

#include "vocabulary/schema.h"

#include "pattern/modifiers.h"

#include <numbers>

namespace candelabra {

const ItemInfo Checker::vocabulary = described<Checker>([] {
    return schema<Checker>("checker",
                           {"Unit cubes of two colours in turn.", "pigment { checker scale 0.3 }",
                            "pigment { checker rgb 0.2, rgb <0.9, 0.8, 0.6> scale 0.3 }"});
});

const ItemInfo Brick::vocabulary = described<Brick>([] {
    using F = Field<Brick>;
    return schema<Brick>(
        "brick",
        {"A wall of bricks: mortar, then brick.", "pigment { brick scale 0.05 }",
         "pigment { brick rgb 0.6, rgb <0.7, 0.3, 0.2> brick_size <0.8, 0.3, 0.4> mortar 0.05 }"},
        F{"brick_size", &Brick::brick_size, item,
          "width, height and depth of a brick and its mortar"},
        F{"mortar", &Brick::mortar, item, "thickness of the mortar"});
});

const ItemInfo Hexagon::vocabulary = described<Hexagon>([] {
    return schema<Hexagon>("hexagon", {"Hexagonal columns along y, of three colours.",
                                       "pigment { hexagon rotate 90*x scale 0.2 }"});
});

const ItemInfo Square::vocabulary = described<Square>([] {
    return schema<Square>("square", {"Square columns along y, of four colours.",
                                     "pigment { square rotate 90*x scale 0.3 }"});
});

const ItemInfo Triangular::vocabulary = described<Triangular>([] {
    return schema<Triangular>("triangular", {"Triangular columns along y, of six colours.",
                                             "pigment { triangular rotate 90*x scale 0.3 }"});
});

const ItemInfo CubicPattern::vocabulary = described<CubicPattern>([] {
    return schema<CubicPattern>(
        "cubic", {"Six colours by the face of a cube around the origin that a point is behind.",
                  "pigment { cubic }"});
});

namespace {

constexpr double tile_margin = 1e-10;

/// Returns the remainder of a floored division, in [0, divisor).
double wrapped(double value, double divisor) {
    return value - divisor * std::floor(value / divisor);
}

double fraction(double value) { return value - std::floor(value); }

}  // namespace

double evaluate(const Checker&, const Vec3& point) {
    const double sum = std::floor(point.x + tile_margin) + std::floor(point.y + tile_margin) +
                       std::floor(point.z + tile_margin);
    return std::fmod(std::abs(sum), 2);
}

double evaluate(const Brick& brick, const Vec3& point) {
    const double mortar = single_precision(brick.mortar - 2 * tile_margin);
    const Vec3 at = (point + Vec3(mortar + tile_margin)) / brick.brick_size;
    const Vec3 seam = Vec3(mortar) / brick.brick_size;
    if (fraction(at.y) <= seam.y) return 0;
    // Every other row is shifted by half a brick: one half of the rows along x, the other along z.
    const bool even = fraction(at.y / 2) <= 0.5;
    const double x = even ? at.x : at.x + 0.5;
    const double z = even ? at.z + 0.5 : at.z;
    return fraction(x) <= seam.x || fraction(z) <= seam.z ? 0 : 1;
}

double evaluate(const Hexagon&, const Vec3& point) {
    // The plane is divided into rectangles: some lie inside one hexagon, the others are split by
    // the slanted edge between two.
    constexpr auto outer = std::array{0, 1, 1, 2, 2, 0};
    constexpr auto inner = std::array{2, 2, 0, 0, 1, 1};
    constexpr auto below = std::array{0, 2, 1, 0, 2, 1};
    constexpr auto above = std::array{2, 1, 0, 2, 1, 0};
    const double z = point.z < 0 ? 5.196152424 - std::abs(point.z) : point.z;
    const double column = wrapped(std::abs(point.x) / 0.5, 6);
    const double row = wrapped(z / 0.866025404, 6);
    const auto m = static_cast<int>(column) % 6, n = static_cast<int>(row) % 6;
    const auto at = static_cast<std::size_t>(n);
    if (m == 0 || m == 5) return outer[at];
    if (m == 2 || m == 3) return inner[at];
    double across = column - m;
    const double up = row - n;
    if ((m + n) % 2 == 1) across = 1 - across;
    if (across == 0) across = 0.0001;
    return up / across < 1 ? below[at] : above[at];
}

double evaluate(const Square&, const Vec3& point) {
    const bool odd_x = wrapped(std::floor(point.x), 2) != 0;
    const bool odd_z = wrapped(std::floor(point.z), 2) != 0;
    if (!odd_x) return odd_z ? 1 : 0;
    return odd_z ? 2 : 3;
}

double evaluate(const Triangular&, const Vec3& point) {
    constexpr double height = std::numbers::sqrt3;  // of a period along z: two rows
    const double x = wrapped(point.x, 3);
    double z = wrapped(point.z, height);
    const bool upper = z >= height / 2;
    if (upper) z = height - z;
    const int column = static_cast<int>(x);
    const double across = x - column;
    int part = 1;
    if (across != 0) {
        const bool right = z / across < height, left = z / (1 - across) < height;
        if (right && left)
            part = 0;
        else if (right)
            part = 3;
    }
    const int turned = part % 2 == 1 ? part + 2 * column : 6 + part - 2 * column;
    const int value = ((turned % 6) + 6) % 6;
    return upper ? 5 - value : value;
}

double evaluate(const CubicPattern&, const Vec3& point) {
    const Vec3 size = glm::abs(point);
    if (point.x >= 0 && point.x >= size.y && point.x >= size.z) return 0;
    if (point.y >= 0 && point.y >= size.x && point.y >= size.z) return 1;
    if (point.z >= 0 && point.z >= size.x && point.z >= size.y) return 2;
    if (point.x < 0 && size.x >= size.y && size.x >= size.z) return 3;
    if (point.y < 0 && size.y >= size.x && size.y >= size.z) return 4;
    return 5;
}

}  // namespace candelabra
