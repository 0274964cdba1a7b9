// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/brightness.h"

#include "base/circle.h"
#include "base/elementary.h"
#include "base/running_sums.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Numbers of patches of a sphere: from the lower pole to the upper one, and around it.
constexpr std::size_t bands = 6, sectors = 12;

bool within(const BrightFace& face, const Vec2& place) {
    const double x = 2 * place.x - 1, y = 2 * place.y - 1, r2 = x * x + y * y;
    switch (face.outline) {
        case BrightFace::triangle:
            return place.x + place.y <= 1;
        case BrightFace::disc:
            return r2 <= 1 && r2 >= face.hole * face.hole;
        default:
            return true;
    }
}

/// Angle around the y axis to a direction, in turns from 0 to 1.
double turn_of(const Vec3& direction) {
    const double turn = math::atan2(direction.z, direction.x) / (2 * pi);
    return turn < 0 ? turn + 1 : turn;
}

}  // namespace

Brightness::Brightness(const std::vector<BrightFace>& faces, bool solid, int cells,
                       FunctionRef<double(const Vec3&)> luminance)
    : solid_(solid) {
    double longest = 0;
    for (const BrightFace& face : faces)
        longest = std::max({longest, length(face.side1), length(face.side2)});
    for (const BrightFace& face : faces) {
        const Vec3 upright = cross(face.side1, face.side2);
        if (!(length(upright) > 0)) continue;
        const auto cells_along = [&](const Vec3& side) {
            return static_cast<std::size_t>(std::ceil(cells * length(side) / longest));
        };
        const Vec3 first = cross(face.side2, upright), second = cross(face.side1, upright);
        const Flat flat{face.corner,
                        face.side1,
                        face.side2,
                        unit(upright),
                        first / dot(first, face.side1),
                        second / dot(second, face.side2)};
        faces_.push_back({flat, length(upright),
                          BrightCells(cells_along(face.side1), cells_along(face.side2),
                                      [&](const Vec2& place) -> std::optional<double> {
                                          if (!within(face, place)) return {};
                                          return luminance(flat.at(place));
                                      })});
    }
    take_means();
}

Brightness::Brightness(const Vec3& centre, double radius, int cells,
                       FunctionRef<double(const Vec3&)> luminance)
    : solid_(true) {
    const auto cells_of = [&](std::size_t parts) {
        return (static_cast<std::size_t>(cells) + parts - 1) / parts;
    };
    constexpr double rise = 2.0 / bands, turn = 1.0 / sectors;
    for (std::size_t i = 0; i < bands * sectors; ++i) {
        const double low = rise * static_cast<double>(i / sectors) - 1,
                     start = turn * static_cast<double>(i % sectors);
        const Vec3 outwards = at_height(low + rise / 2, start + turn / 2);
        const double corner_cosine = std::fmin(dot(outwards, at_height(low, start)),
                                               dot(outwards, at_height(low + rise, start)));
        const double corner_sine = std::sqrt(1 - corner_cosine * corner_cosine);
        const Patch patch{centre, radius,   low,           rise,       start,
                          turn,   outwards, corner_cosine, corner_sine};
        faces_.push_back({patch, 4 * pi * radius * radius / (bands * sectors),
                          BrightCells(cells_of(bands), cells_of(sectors), [&](const Vec2& place) {
                              return luminance(patch.at(place));
                          })});
    }
    take_means();
}

void Brightness::take_means() {
    double area = 0;
    for (const Face& face : faces_) {
        area += face.area * face.cells.covered();
        mean_ += face.area * face.cells.mean();
        mean_square_ += face.area * face.cells.mean_square();
    }
    if (!(area > 0)) return;
    mean_ /= area;
    mean_square_ /= area;
}

Vec3 Brightness::Flat::at(const Vec2& place) const {
    return corner + place.x * side1 + place.y * side2;
}

Vec2 Brightness::Flat::place_of(const Vec3& position) const {
    return {dot(position - corner, across1), dot(position - corner, across2)};
}

double Brightness::Patch::height(const Vec3& point) const {
    const Vec3 offset = point - centre;
    const double along = dot(offset, outwards), square = dot(offset, offset);
    if (square <= radius * radius) return along - radius;
    // Height above the nearest point of the patch, which is the maximum; the mean is lower.
    const double distance = std::sqrt(square);
    double most = distance - radius;
    if (along < distance * reach_cosine) {
        const double across = std::sqrt(std::fmax(square - along * along, 0));
        most = along * reach_cosine + across * reach_sine - radius;
    }
    return most > 0 ? 0.5 * (most + std::fmax(along - radius, 0)) : most;
}

Vec3 Brightness::Patch::at(const Vec2& place) const {
    return centre + radius * at_height(low + place.x * rise, start + place.y * turn);
}

Vec2 Brightness::Patch::place_of(const Vec3& position) const {
    const Vec3 direction = normal_at(position);
    return {(direction.y - low) / rise, (turn_of(direction) - start) / turn};
}

Brightness::View::View(const Brightness& map, const Vec3& from)
    : map_(map), from_(from), sides_(map.solid_ ? 1 : 0) {
    if (map_.faces_.empty()) return;
    const auto* patch = std::get_if<Patch>(&map_.faces_.front().shape);
    if (patch && length(from - patch->centre) < patch->radius) sides_ = -1;
    double sum = 0;
    for (const Face& face : map_.faces_) weights_.push_back(sum += weight(face));
}

/// Rough estimate of the irradiance from the face.
double Brightness::View::weight(const Face& face) const {
    return std::visit(
        [&](const auto& shape) {
            const double height = seen(shape.height(from_));
            const Vec3 offset = shape.middle() - from_;
            const double square = dot(offset, offset) + 0.1 * face.area;
            if (!(height > 0)) return 0.0;
            return face.area * face.cells.mean() * height / (square * std::sqrt(square));
        },
        face.shape);
}

/// `of_face` is the relative density of the position within its face, 1 where it is uniform.
double Brightness::View::density(std::size_t index, const Vec3& position, double of_face) const {
    const Face& face = map_.faces_[index];
    const Vec3 offset = position - from_;
    const Vec3 normal =
        std::visit([&](const auto& shape) { return shape.normal_at(position); }, face.shape);
    const double square = dot(offset, offset), height = seen(-dot(offset, normal));
    if (!(height > 0)) return 0;
    return share_of(weights(), index) * of_face / face.area * square * std::sqrt(square) / height;
}

Brightness::View::Drawn Brightness::View::draw(const Vec2& u) const {
    const DrawnShare drawn = drawn_share(weights(), u.x);
    const Face& face = map_.faces_[drawn.index];
    const BrightCells::Drawn cell = face.cells.draw({drawn.within, u.y});
    const Vec3 position =
        std::visit([&](const auto& shape) { return shape.at(cell.at); }, face.shape);
    return {position, density(drawn.index, position, cell.density)};
}

double Brightness::View::density(const Vec3& position) const {
    const std::size_t index = any() ? face_at(position) : map_.faces_.size();
    if (index == map_.faces_.size() || !(map_.faces_[index].cells.mean() > 0)) return 0;
    const Face& face = map_.faces_[index];
    const Vec2 place =
        std::visit([&](const auto& shape) { return shape.place_of(position); }, face.shape);
    return density(index, position, face.cells.density(place));
}

/// Index of the face in whose plane the point lies, among those turned to the receiver; for
/// spheres, of the patch. The number of faces if there is none.
std::size_t Brightness::View::face_at(const Vec3& position) const {
    if (const auto* patch = std::get_if<Patch>(&map_.faces_.front().shape)) {
        const Vec3 direction = patch->normal_at(position);
        const auto part = [](double along, std::size_t count) {
            const double at = std::clamp(along, 0.0, 1.0) * static_cast<double>(count);
            return std::min(static_cast<std::size_t>(at), count - 1);
        };
        return part((direction.y + 1) / 2, bands) * sectors + part(turn_of(direction), sectors);
    }
    std::size_t nearest = map_.faces_.size();
    double least = INFINITY;
    for (std::size_t i = 0; i < map_.faces_.size(); ++i) {
        const Flat& flat = std::get<Flat>(map_.faces_[i].shape);
        const double height = std::abs(flat.height(position));
        if (height < least && (!map_.solid_ || flat.height(from_) > 0)) {
            least = height;
            nearest = i;
        }
    }
    return nearest;
}

}  // namespace candelabra
