// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/height_field.h"

#include "vocabulary/schema.h"

#include <algorithm>

const ItemInfo HeightField::vocabulary = described<HeightField>([] {
    using F = Field<HeightField>;
    constexpr auto file = &HeightField::file;
    return schema<HeightField>(
        "height_field", "A landscape over the unit square.",
        maybe(F{"function", &HeightField::function, positional,
                "`function width, height { ... }` of x and y from 0 to 1"}),
        maybe(F{"file", file, positional, "name of a picture"}),
        F{"png", file, item, "name of a picture of this kind"},
        F{"gif", file, item, "name of a picture of this kind"},
        F{"tga", file, item, "name of a picture of this kind"},
        F{"pgm", file, item, "name of a picture of this kind"},
        F{"ppm", file, item, "name of a picture of this kind"},
        F{"bmp", file, item, "name of a picture of this kind"},
        F{"jpeg", file, item, "name of a picture of this kind"},
        F{"tiff", file, item, "name of a picture of this kind"},
        F{"exr", file, item, "name of a picture of this kind"},
        F{"hdr", file, item, "name of a picture of this kind"},
        F{"sys", file, item, "name of a picture of this kind"},
        F{"water_level", &HeightField::water_level, item, "height below which is no surface"},
        F{"smooth", &HeightField::smooth, flag, "shades the landscape as if it were curved"},
        F{"gamma", &HeightField::gamma, item,
          "of the picture's values, which are taken as they "
          "are without it"},
        F{"hierarchy", &HeightField::hierarchy, flag, "accepted, and always so"});
});

namespace {

/// Normal of the plane through three heights of neighbours, x and z pointing along the square.
Vec3 slope_normal(const HeightGrid& grid, double rise_x, double rise_z) {
    return unit(Vec3(-rise_x * (grid.width - 1), 1, -rise_z * (grid.height - 1)));
}

/// The normal of a pixel, of no particular length: the mean of those to its neighbours. As in
/// POV-Ray, all are unit vectors where pixels are units and heights go to 65536, so that the flat
/// ones count most, and the mean's parts are whole numbers up to 32767.
Vec3 pixel_normal(const HeightGrid& grid, int x, int z) {
    constexpr double highest = 65536, longest = 32767;
    Vec3 sum(0);
    for (const int dx : {-1, 1})
        for (const int dz : {-1, 1}) {
            const int nx = x + dx, nz = z + dz;
            if (nx < 0 || nz < 0 || nx >= grid.width || nz >= grid.height) continue;
            sum += unit(Vec3(-highest * dx * (grid.at(nx, z) - grid.at(x, z)), 1,
                             -highest * dz * (grid.at(x, nz) - grid.at(x, z))));
        }
    return unit(glm::trunc(longest * unit(sum)) * Vec3(grid.width - 1, highest, grid.height - 1));
}

/// The plane of one half of a cell, in cells: height(x, z) = base + rise . (x, z).
struct Half {
    double base, rise_x, rise_z;
    double height(double x, double z) const { return base + rise_x * x + rise_z * z; }
};

/// The half below the diagonal from (1, 0) to (0, 1), or that above it.
Half half_of(const HeightGrid& grid, int x, int z, bool upper) {
    const double right = grid.at(x + 1, z), far = grid.at(x, z + 1);
    if (!upper) {
        const double base = grid.at(x, z);
        return {base, right - base, far - base};
    }
    const double corner = grid.at(x + 1, z + 1), rise_x = corner - far, rise_z = corner - right;
    return {corner - rise_x - rise_z, rise_x, rise_z};
}

Vec3 normal_at(const BuiltHeightField& field, const Half& half, int x, int z, const Vec2& in_cell) {
    const HeightGrid& grid = *field.grid;
    const Vec3 flat = slope_normal(grid, half.rise_x, half.rise_z);
    if (!field.smooth) return flat;
    const auto corner = [&](int dx, int dz) {
        return field
            .normals[static_cast<std::size_t>(z + dz) * static_cast<std::size_t>(grid.width) +
                     static_cast<std::size_t>(x + dx)];
    };
    const double u = in_cell.x, v = in_cell.y;
    return unit((1 - v) * ((1 - u) * corner(0, 0) + u * corner(1, 0)) +
                v * ((1 - u) * corner(0, 1) + u * corner(1, 1)));
}

/// Follows a ray over the cells. The ray is in cells: x and z count pixels.
class Walk {
public:
    Walk(const BuiltHeightField& field, const Ray& ray, const Vec3& direction, Crossings& found)
        : field_(field),
          grid_(*field.grid),
          ray_(ray),
          steps_(Vec3(1) / ray.direction),
          direction_(direction),
          found_(found) {}

    /// Up to the first crossing in `wanted`.
    void along(const Interval& range, const Interval& wanted) {
        double t = range.min;
        above_ = true;
        bool first = true;
        const auto met = [&] {
            return found_.size() > 0 && found_[found_.size() - 1].t > wanted.min;
        };
        while (t < range.max && t <= wanted.max && !met()) {
            // The cell in which the ray is right behind t.
            const double probe = t + 1e-9 * (range.max - range.min);
            const int x = cell(ray_.origin.x + probe * ray_.direction.x, grid_.width);
            const int z = cell(ray_.origin.z + probe * ray_.direction.z, grid_.height);
            const double over = std::min(range.max, leaves_block(x, z, probe));
            if (passes_over(block_at(x, z), {t, over}, first)) {
                first = false;
                t = over;
                continue;
            }
            const double end = std::min(range.max, leaves(x, z, probe, 1));
            over_cell(x, z, {t, end}, first);
            first = false;
            t = end;
        }
    }

private:
    static int cell(double at, int count) { return std::clamp(static_cast<int>(at), 0, count - 2); }

    const HeightBlock& block_at(int x, int z) const {
        const int row = (grid_.width - 2) / height_block + 1;
        return field_.blocks[static_cast<std::size_t>(z / height_block * row + x / height_block)];
    }

    double leaves_block(int x, int z, double after) const {
        return leaves(x / height_block * height_block, z / height_block * height_block, after,
                      height_block);
    }

    /// Whether the ray stays on its side of all that the block has.
    bool passes_over(const HeightBlock& block, const Interval& range, bool first) {
        const double a = ray_.origin.y + range.min * ray_.direction.y;
        const double b = ray_.origin.y + range.max * ray_.direction.y;
        const bool above = std::min(a, b) > block.high, below = std::max(a, b) < block.low;
        if (first && (above || below)) above_ = above;
        return above_ ? above : below;
    }

    /// Where the ray leaves a square of cells.
    double leaves(int x, int z, double after, int size) const {
        double t = std::numeric_limits<double>::infinity();
        // Along the other axis this is infinite, or no number: it bounds nothing.
        const auto bound = [&](double origin, double step, int low) {
            const double at = (low + (step > 0 ? size : 0) - origin) * step;
            if (at > after) t = std::min(t, at);
        };
        bound(ray_.origin.x, steps_.x, x);
        bound(ray_.origin.z, steps_.z, z);
        return t;
    }

    void over_cell(int x, int z, const Interval& range, bool first) {
        const Ray local{ray_.origin - Vec3(x, 0, z), ray_.direction};
        const double sum = local.origin.x + local.origin.z - 1;
        const double speed = local.direction.x + local.direction.z;
        const double middle = speed != 0 ? -sum / speed : range.max;
        const auto upper_at = [&](double t) { return sum + t * speed > 0; };
        if (!(middle > range.min && middle < range.max))
            return over_half(x, z, upper_at(0.5 * (range.min + range.max)), local, range, first);
        over_half(x, z, upper_at(0.5 * (range.min + middle)), local, {range.min, middle}, first);
        over_half(x, z, upper_at(0.5 * (middle + range.max)), local, {middle, range.max}, false);
    }

    void over_half(int x, int z, bool upper, const Ray& local, const Interval& range, bool first) {
        const Half half = half_of(grid_, x, z, upper);
        const auto height = [&](double t) {
            const Vec3 p = local.at(t);
            return p.y - half.height(p.x, p.z);
        };
        const double start = height(range.min), end = height(range.max);
        if (first) above_ = start > 0;
        const bool above_after = end > 0;
        if (above_after == above_) return;
        above_ = above_after;
        const double share = start == end ? 0.5 : std::clamp(start / (start - end), 0.0, 1.0);
        const double t = range.min + share * (range.max - range.min);
        const Vec3 p = local.at(t);
        if (p.y < field_.water_level) return;
        const Vec3 normal = normal_at(field_, half, x, z, {p.x, p.z});
        const Vec3 flat = slope_normal(grid_, half.rise_x, half.rise_z);
        const bool entering =
            field_.smooth ? dot(flat, direction_) < 0 : dot(normal, direction_) < 0;
        found_.add({t, normal, entering});
    }

    const BuiltHeightField& field_;
    const HeightGrid& grid_;
    const Ray& ray_;
    const Vec3 steps_;       ///< of t from one pixel to the next
    const Vec3& direction_;  ///< in the unit square
    Crossings& found_;
    bool above_ = true;
};

std::vector<HeightBlock> blocks_of(const HeightGrid& grid) {
    std::vector<HeightBlock> blocks;
    for (int z = 0; z < grid.height - 1; z += height_block)
        for (int x = 0; x < grid.width - 1; x += height_block) {
            HeightBlock block{grid.at(x, z), grid.at(x, z)};
            for (int v = z; v <= std::min(z + height_block, grid.height - 1); ++v)
                for (int u = x; u <= std::min(x + height_block, grid.width - 1); ++u) {
                    block.low = std::min(block.low, grid.at(u, v));
                    block.high = std::max(block.high, grid.at(u, v));
                }
            blocks.push_back(block);
        }
    return blocks;
}

}  // namespace

std::string problem(const HeightField& field) {
    if (!field.grid) return "a `height_field` needs a picture or a function";
    return field.grid->width >= 2 && field.grid->height >= 2
               ? ""
               : "a `height_field` needs at least 2 by 2 heights";
}

BuiltHeightField build(const HeightField& field) {
    const HeightGrid& grid = *field.grid;
    const auto [low, high] = std::ranges::minmax_element(grid.values);
    BuiltHeightField result{field.grid,     field.water_level, field.smooth,
                            *low / 65536.0, *high / 65536.0,   {},
                            blocks_of(grid)};
    if (!field.smooth) return result;
    for (int z = 0; z < grid.height; ++z)
        for (int x = 0; x < grid.width; ++x) result.normals.push_back(pixel_normal(grid, x, z));
    return result;
}

Box bounds(const BuiltHeightField& field) {
    constexpr double least = 0.001 / 65536;
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
    const Vec3 cells(field.grid->width - 1, 1, field.grid->height - 1);
    // From where it comes in, so that a far origin costs no digits.
    const Vec3 start = ray.at(range.min);
    const Ray over{cells * start, cells * ray.direction};
    Crossings met;
    Walk(field, over, ray.direction, met)
        .along({0, range.max - range.min}, {wanted.min - range.min, wanted.max - range.min});
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
    return point.y < half_of(grid, column, row, u + v > 1).height(u, v);
}

Box inside_bounds(const BuiltHeightField& field) {
    return {Vec3(0, -std::numeric_limits<double>::infinity(), 0), Vec3(1, bounds(field).high.y, 1)};
}
