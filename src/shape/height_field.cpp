// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/height_field.h"

#include "base/long_work.h"
#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

const ItemInfo HeightField::vocabulary = described<HeightField>([] {
    using F = Field<HeightField>;
    constexpr auto file = &HeightField::file;
    return schema<HeightField>(
        "height_field",
        {"A landscape over the unit square.",
         "height_field { function 120, 120 { 0.5 + 0.3*sin(12*x)*cos(12*y) } smooth translate "
         "<-0.5, 0, -0.5> scale <2.6, 1, 2.6> }",
         "height_field { png \"Mount1.png\" water_level 0.1 translate <-0.5, 0, -0.5> scale <2.6, "
         "0.9, 2.6> }",
         "height_field { pot \"mtmand.pot\" gamma 1 translate <-0.5, 0, -0.5> scale <2.6, 0.9, "
         "2.6> }"},
        maybe(F{"function", &HeightField::function, positional,
                "`function width, height { ... }` of x and y from 0 to 1"}),
        maybe(F{"file", file, positional, "name of a picture"}),
        F{"png", file, item, "picture file"}, F{"gif", file, item, "picture file"},
        F{"pot", file, item,
          "name of a GIF picture of twice the width: the higher bytes of all heights, and beside "
          "them the lower ones"},
        F{"tga", file, item, "picture file"}, F{"pgm", file, item, "picture file"},
        F{"ppm", file, item, "picture file"}, F{"bmp", file, item, "picture file"},
        F{"jpeg", file, item, "picture file"}, F{"tiff", file, item, "picture file"},
        F{"exr", file, item, "picture file"}, F{"hdr", file, item, "picture file"},
        F{"sys", file, item, "picture file"},
        F{"water_level", &HeightField::water_level, item, "height below which is no surface"},
        F{"smooth", &HeightField::smooth, flag, "shades the landscape as if it were curved"},
        F{"gamma", &HeightField::gamma, item,
          "of the picture's values, which are taken as they "
          "are without it"},
        F{"hierarchy", &HeightField::hierarchy, flag, "accepted, and always so"});
});

namespace {

/// Units of height in a height of 1.
constexpr double highest = 65536;

/// Normal of the plane through three neighbouring heights, x and z pointing along the square.
Vec3 slope_normal(const HeightGrid& grid, double rise_x, double rise_z) {
    return unit(Vec3(-rise_x * (grid.width - 1), highest, -rise_z * (grid.height - 1)));
}

/// Unit normal of a pixel: the mean of the normals towards its neighbours. As in POV-Ray, these
/// have length 1 in a space where pixels are units and heights go to 65536, so that the flat ones
/// count most, and the components of the mean are whole numbers up to 32767.
Vec3 pixel_normal(const HeightGrid& grid, int x, int z) {
    constexpr double longest = 32767;
    Vec3 sum(0);
    for (const int dx : {-1, 1})
        for (const int dz : {-1, 1}) {
            const int nx = x + dx, nz = z + dz;
            if (nx < 0 || nz < 0 || nx >= grid.width || nz >= grid.height) continue;
            sum += unit(Vec3(-dx * (grid.at(nx, z) - grid.at(x, z)), 1,
                             -dz * (grid.at(x, nz) - grid.at(x, z))));
        }
    return unit(glm::trunc(longest * unit(sum)) * Vec3(grid.width - 1, highest, grid.height - 1));
}

/// The plane of one half of a cell, in cells and units of height:
/// height(x, z) = base + rise . (x, z).
struct Half {
    double base, rise_x, rise_z;
    double height(double x, double z) const { return base + rise_x * x + rise_z * z; }
};

/// The heights at the corners (0, 0), (1, 0), (0, 1) and (1, 1) of a cell.
struct Cell {
    std::uint16_t origin, right, far, corner;

    Cell(const HeightGrid& grid, int x, int z)
        : origin(grid.at(x, z)),
          right(grid.at(x + 1, z)),
          far(grid.at(x, z + 1)),
          corner(grid.at(x + 1, z + 1)) {}

    HeightBlock block() const {
        return {std::min(std::min(origin, right), std::min(far, corner)),
                std::max(std::max(origin, right), std::max(far, corner))};
    }

    /// The half above or below the diagonal from (1, 0) to (0, 1).
    Half half(bool upper) const {
        const double at_right = right, at_far = far;
        if (!upper) return {static_cast<double>(origin), at_right - origin, at_far - origin};
        const double rise_x = corner - at_far, rise_z = corner - at_right;
        return {corner - rise_x - rise_z, rise_x, rise_z};
    }
};

Vec3 normal_at(const BuiltHeightField& field, const Half& half, int x, int z, const Vec2& in_cell) {
    const HeightGrid& grid = *field.grid;
    constexpr std::size_t cells_of_step = 4;
    count_long_work(grid.values.size() / cells_of_step);
    const Vec3 flat = slope_normal(grid, half.rise_x, half.rise_z);
    if (!field.smooth) return flat;
    const auto corner = [&](int dx, int dz) {
        const Vec3 normal = pixel_normal(grid, x + dx, z + dz);
        return field.stretched ? normal / length(field.stretched->normal(normal)) : normal;
    };
    const double u = in_cell.x, v = in_cell.y;
    return unit((1 - v) * ((1 - u) * corner(0, 0) + u * corner(1, 0)) +
                v * ((1 - u) * corner(0, 1) + u * corner(1, 1)));
}

/// Follows a ray over the cells. The ray is in cells and units of height: x and z count pixels.
class Walk {
public:
    Walk(const BuiltHeightField& field, const Ray& ray, const Vec3& direction, double end,
         Crossings& found)
        : field_(field),
          grid_(*field.grid),
          ray_(ray),
          steps_(Vec3(1) / ray.direction),
          direction_(direction),
          end_(end),
          found_(found) {}

    /// From 0 to the end, up to the first crossing in `wanted`.
    void along(const Interval& wanted) { over_blocks(field_.levels.size(), {0, end_}, wanted); }

private:
    static int cell(double at, int count) { return std::clamp(static_cast<int>(at), 0, count - 2); }

    /// Follows the ray over the blocks of a level, and over the smaller blocks in those that it may
    /// hit; at level 0 over the cells.
    void over_blocks(std::size_t level, const Interval& range, const Interval& wanted) {
        const HeightBlocks* const blocks = level > 0 ? &field_.levels[level - 1] : nullptr;
        const int size = blocks ? blocks->size : 1;
        for (double t = range.min; t < range.max && t <= wanted.max && !met(wanted);) {
            // The cell that the ray is in right behind t.
            const double probe = t + 1e-9 * end_;
            const int x = cell(ray_.origin.x + probe * ray_.direction.x, grid_.width);
            const int z = cell(ray_.origin.z + probe * ray_.direction.z, grid_.height);
            const Interval within{
                t, std::min(range.max, leaves(x / size * size, z / size * size, probe, size))};
            if (!blocks)
                over_cell(x, z, within);
            else if (!passes_over(blocks->at(x, z), within))
                over_blocks(level - 1, within, wanted);
            t = within.max;
        }
    }

    bool met(const Interval& wanted) const {
        return found_.size() > 0 && found_[found_.size() - 1].t > wanted.min;
    }

    /// Whether the ray stays on its side of the whole block.
    bool passes_over(const HeightBlock& block, const Interval& range) {
        const double a = ray_.origin.y + range.min * ray_.direction.y;
        const double b = ray_.origin.y + range.max * ray_.direction.y;
        const bool above = std::min(a, b) > block.high, below = std::max(a, b) < block.low;
        if (!(above || below)) return false;
        if (first_) above_ = above;
        first_ = false;
        return above_ ? above : below;
    }

    /// Parameter at which the ray leaves a square of cells.
    double leaves(int x, int z, double after, int size) const {
        double t = std::numeric_limits<double>::infinity();
        // For an axis that the ray is parallel to, this is infinite or NaN and bounds nothing.
        const auto bound = [&](double origin, double step, int low) {
            const double at = (low + (step > 0 ? size : 0) - origin) * step;
            if (at > after) t = std::min(t, at);
        };
        bound(ray_.origin.x, steps_.x, x);
        bound(ray_.origin.z, steps_.z, z);
        return t;
    }

    void over_cell(int x, int z, const Interval& range) {
        const Cell cell(grid_, x, z);
        if (passes_over(cell.block(), range)) return;
        const Ray local{ray_.origin - Vec3(x, 0, z), ray_.direction};
        const double sum = local.origin.x + local.origin.z - 1;
        const double speed = local.direction.x + local.direction.z;
        const double middle = speed != 0 ? -sum / speed : range.max;
        const auto upper_at = [&](double t) { return sum + t * speed > 0; };
        if (!(middle > range.min && middle < range.max))
            return over_half(x, z, cell.half(upper_at(0.5 * (range.min + range.max))), local,
                             range);
        over_half(x, z, cell.half(upper_at(0.5 * (range.min + middle))), local,
                  {range.min, middle});
        over_half(x, z, cell.half(upper_at(0.5 * (middle + range.max))), local,
                  {middle, range.max});
    }

    void over_half(int x, int z, const Half& half, const Ray& local, const Interval& range) {
        const auto height = [&](double t) {
            const Vec3 p = local.at(t);
            return p.y - half.height(p.x, p.z);
        };
        const double start = height(range.min), end = height(range.max);
        if (first_) above_ = start > 0;
        first_ = false;
        const bool above_after = end > 0;
        if (above_after == above_) return;
        above_ = above_after;
        const double share = start == end ? 0.5 : std::clamp(start / (start - end), 0.0, 1.0);
        const double t = range.min + share * (range.max - range.min);
        const Vec3 p = local.at(t);
        if (p.y < highest * field_.water_level) return;
        const Vec3 normal = normal_at(field_, half, x, z, {p.x, p.z});
        const Vec3 flat = slope_normal(grid_, half.rise_x, half.rise_z);
        const bool entering =
            field_.smooth ? dot(flat, direction_) < 0 : dot(normal, direction_) < 0;
        found_.add({t, normal, entering});
    }

    const BuiltHeightField& field_;
    const HeightGrid& grid_;
    const Ray& ray_;
    const Vec3 steps_;       ///< in t from one pixel to the next
    const Vec3& direction_;  ///< in the unit square
    const double end_;       ///< of the ray
    Crossings& found_;
    bool first_ = true;  ///< the side of the ray is not known yet
    bool above_ = true;
};

/// Heights of a block of size by size cells.
HeightBlock block_of(const HeightGrid& grid, int x, int z, int size) {
    HeightBlock block{grid.at(x, z), grid.at(x, z)};
    for (int v = z; v <= std::min(z + size, grid.height - 1); ++v)
        for (int u = x; u <= std::min(x + size, grid.width - 1); ++u) {
            block.low = std::min(block.low, grid.at(u, v));
            block.high = std::max(block.high, grid.at(u, v));
        }
    return block;
}

std::vector<HeightBlocks> levels_of(const HeightGrid& grid) {
    std::vector<HeightBlocks> levels;
    for (const int size : {4, 16, 64}) {
        HeightBlocks level{size, (grid.width - 2) / size + 1, {}};
        for (int z = 0; z < grid.height - 1; z += size)
            for (int x = 0; x < grid.width - 1; x += size)
                level.blocks.push_back(block_of(grid, x, z, size));
        levels.push_back(std::move(level));
    }
    return levels;
}

}  // namespace

std::string problem(const HeightField& field) {
    return field.grid ? "" : "a `height_field` needs a picture or a function";
}

std::string vanishes(const HeightField& field) {
    const bool some = field.grid->width >= 2 && field.grid->height >= 2;
    return some ? "" : "it has fewer than 2 by 2 heights";
}

BuiltHeightField build(const HeightField& field) {
    const HeightGrid& grid = *field.grid;
    const auto [low, high] = std::ranges::minmax_element(grid.values);
    return {field.grid,      field.water_level, field.smooth, *low / highest,
            *high / highest, levels_of(grid),   nullptr};
}

Box bounds(const BuiltHeightField& field) {
    constexpr double least = 0.001 / highest;
    return {Vec3(0, std::fmax(field.low, field.water_level) - least, 0),
            Vec3(1, std::fmax(field.high, field.water_level) + least, 1)};
}

void crossings(const BuiltHeightField& field, const Ray& ray, Crossings& found) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    nearest_crossings(field, ray, {infinity, infinity}, found);
}

void nearest_crossings(const BuiltHeightField& field, const Ray& ray, const Interval& wanted,
                       Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    const Interval range =
        clip(ray, bounds(field),
             {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()});
    if (!(range.min < range.max)) return;
    const Vec3 cells(field.grid->width - 1, highest, field.grid->height - 1);
    // Computed from the entry point, so that a distant origin loses no digits.
    const Vec3 start = ray.at(range.min);
    const Ray over{cells * start, cells * ray.direction};
    Crossings met;
    Walk(field, over, ray.direction, range.max - range.min, met)
        .along({wanted.min - range.min, wanted.max - range.min});
    for (std::size_t i = 0; i < met.size(); ++i)
        found.add({range.min + met[i].t, met[i].normal, met[i].entering});
}

bool inside(const BuiltHeightField& field, const Vec3& point) {
    const HeightGrid& grid = *field.grid;
    const double x = point.x * (grid.width - 1), z = point.z * (grid.height - 1);
    if (!(x >= 0 && z >= 0 && x < grid.width - 1 && z < grid.height - 1)) return false;
    if (point.y < field.water_level) return true;
    const int column = static_cast<int>(x), row = static_cast<int>(z);
    const double u = x - column, v = z - row;
    return highest * point.y < Cell(grid, column, row).half(u + v > 1).height(u, v);
}

Box inside_bounds(const BuiltHeightField& field) {
    return {Vec3(0, -std::numeric_limits<double>::infinity(), 0), Vec3(1, bounds(field).high.y, 1)};
}

}  // namespace candelabra
