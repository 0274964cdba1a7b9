// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/brightness.h"

#include "base/running_sums.h"

#include <algorithm>
#include <cmath>

namespace {

/// Points that each cell is asked at, in each direction.
constexpr int asked = 2;
/// Share of a cell's brightness that is what its neighbours have: bright spots reach into cells
/// whose points miss them.
constexpr double neighbours = 0.3;

bool within(const BrightFace& face, double along1, double along2) {
    const double x = 2 * along1 - 1, y = 2 * along2 - 1, r2 = x * x + y * y;
    switch (face.outline) {
        case BrightFace::triangle:
            return along1 + along2 <= 1;
        case BrightFace::disc:
            return r2 <= 1 && r2 >= face.hole * face.hole;
        default:
            return true;
    }
}

using Sums = std::span<const double>;

/// The sums within a row of cells.
Sums columns_of(const std::vector<double>& all, std::size_t row, std::size_t count) {
    return Sums(all).subspan(row * count, count);
}

std::size_t cell_at(double along, std::size_t count) {
    const auto cell = static_cast<std::size_t>(along * static_cast<double>(count));
    return std::min(cell, count - 1);
}

}  // namespace

Brightness::Brightness(const std::vector<BrightFace>& faces, bool solid, int cells,
                       FunctionRef<double(const Vec3&)> luminance)
    : solid_(solid) {
    double longest = 0, lit_area = 0, power = 0;
    for (const BrightFace& face : faces)
        longest = std::max({longest, length(face.side1), length(face.side2)});
    for (const BrightFace& face : faces) {
        const Vec3 upright = cross(face.side1, face.side2);
        if (!(length(upright) > 0)) continue;
        const auto cells_along = [&](const Vec3& side) {
            return static_cast<std::size_t>(std::ceil(cells * length(side) / longest));
        };
        Face made{face.corner, face.side1, face.side2};
        made.normal = unit(upright);
        const Vec3 first = cross(face.side2, upright), second = cross(face.side1, upright);
        made.across1 = first / dot(first, face.side1);
        made.across2 = second / dot(second, face.side2);
        made.area = length(upright);
        made.row_count = cells_along(face.side1);
        made.column_count = cells_along(face.side2);
        lit_area += made.area * ask(face, made, luminance);
        power += made.power;
        faces_.push_back(std::move(made));
    }
    mean_ = lit_area > 0 ? power / lit_area : 0;
}

/// Fills in how bright the cells are. Returns the share of the parallelogram that is the face.
double Brightness::ask(const BrightFace& face, Face& made,
                       FunctionRef<double(const Vec3&)> luminance) {
    std::vector<double> seen(made.row_count * made.column_count, 0);
    double inside = 0, all = 0;
    const auto part = [](std::size_t cell, int n, std::size_t count) {
        return (static_cast<double>(cell) + (n + 0.5) / asked) / static_cast<double>(count);
    };
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (int n = 0; n < asked * asked; ++n) {
            const double along1 = part(i / made.column_count, n / asked, made.row_count),
                         along2 = part(i % made.column_count, n % asked, made.column_count);
            if (!within(face, along1, along2)) continue;
            inside += 1;
            seen[i] +=
                std::fmax(luminance(made.corner + along1 * made.side1 + along2 * made.side2), 0);
        }
    const auto at = [&](std::size_t row, std::size_t column) {
        return seen[std::min(row, made.row_count - 1) * made.column_count +
                    std::min(column, made.column_count - 1)];
    };
    double sum = 0;
    for (std::size_t row = 0; row < made.row_count; ++row) {
        double of_row = 0;
        for (std::size_t column = 0; column < made.column_count; ++column) {
            const double beside =
                at(row + 1, column) + at(row - std::min<std::size_t>(row, 1), column) +
                at(row, column + 1) + at(row, column - std::min<std::size_t>(column, 1));
            of_row += (1 - neighbours) * at(row, column) + neighbours / 4 * beside;
            made.columns.push_back(of_row);
            all += at(row, column);
        }
        sum += of_row;
        made.rows.push_back(sum);
    }
    const double points = static_cast<double>(seen.size()) * asked * asked;
    made.power = made.area * all / points;
    return inside / points;
}

Brightness::View::View(const Brightness& map, const Vec3& from) : map_(map), from_(from) {
    for (std::size_t i = 0; i < map_.faces_.size(); ++i) total_ += weight(i);
}

/// By what each face gives, roughly.
double Brightness::View::weight(std::size_t i) const {
    const Face& face = map_.faces_[i];
    const double height = dot(from_ - face.corner, face.normal);
    const Vec3 offset = face.corner + 0.5 * (face.side1 + face.side2) - from_;
    const double square = dot(offset, offset) + 0.1 * face.area;
    if (map_.solid_ && !(height > 0)) return 0;
    return face.power * std::abs(height) / (square * std::sqrt(square));
}

double Brightness::View::density(std::size_t i, const Vec3& position, double share) const {
    const Face& face = map_.faces_[i];
    const Vec3 offset = position - from_;
    const double square = dot(offset, offset), height = std::abs(dot(offset, face.normal));
    const double cells = static_cast<double>(face.row_count * face.column_count);
    if (!(height > 0)) return 0;
    return weight(i) / total_ * share * cells / face.area * square * std::sqrt(square) / height;
}

Brightness::View::Drawn Brightness::View::draw(Vec2 u) const {
    double left = u.x * total_, own = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < map_.faces_.size(); ++i) {
        const double here = weight(i);
        if (!(here > 0)) continue;
        last = i;
        own = here;
        if (left < here) break;
        left -= here;
    }
    const Face& face = map_.faces_[last];
    const Sums rows(face.rows);
    const DrawnShare row = drawn_share(rows, std::fmin(left / own, 1 - 0x1p-53));
    const Sums columns = columns_of(face.columns, row.index, face.column_count);
    const DrawnShare column = drawn_share(columns, u.y);
    const auto along = [](const DrawnShare& drawn, std::size_t count) {
        return (static_cast<double>(drawn.index) + drawn.within) / static_cast<double>(count);
    };
    const Vec3 position = face.corner + along(row, face.row_count) * face.side1 +
                          along(column, face.column_count) * face.side2;
    return {position,
            density(last, position, share_of(rows, row.index) * share_of(columns, column.index))};
}

double Brightness::View::density(const Vec3& position) const {
    if (!any()) return 0;
    // Of the faces that are turned here, the one in whose plane the point lies.
    std::size_t nearest = map_.faces_.size();
    double least = INFINITY;
    for (std::size_t i = 0; i < map_.faces_.size(); ++i) {
        const Face& face = map_.faces_[i];
        const double off = std::abs(dot(position - face.corner, face.normal));
        if (off < least && (!map_.solid_ || dot(from_ - face.corner, face.normal) > 0)) {
            least = off;
            nearest = i;
        }
    }
    if (nearest == map_.faces_.size() || !(map_.faces_[nearest].power > 0)) return 0;
    const Face& face = map_.faces_[nearest];
    const Vec3 offset = position - face.corner;
    const double along1 = std::clamp(dot(offset, face.across1), 0.0, 1.0),
                 along2 = std::clamp(dot(offset, face.across2), 0.0, 1.0);
    const std::size_t row = cell_at(along1, face.row_count),
                      column = cell_at(along2, face.column_count);
    const Sums columns = columns_of(face.columns, row, face.column_count);
    if (!(columns.back() > 0)) return 0;
    return density(nearest, position, share_of(Sums(face.rows), row) * share_of(columns, column));
}
