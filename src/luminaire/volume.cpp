// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/volume.h"

#include "base/circle.h"
#include "base/random.h"
#include "base/ray.h"
#include "luminaire/light_proxy.h"

#include <algorithm>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Fraction of the points that are spread evenly over all cells.
constexpr double in_any_cell = 0.25;
/// Distance in radii of the box below which directions are sampled as well, and the fraction of
/// points drawn so: without it, the light of nearby emission is unbounded.
constexpr double near_volume = 3, by_direction = 0.5;

/// A number in [0, 1) from the later digits of u, in practice independent of u.
double second_number(double u) {
    constexpr double steps = 1 << 20;
    return u * steps - std::floor(u * steps);
}

double volume_of(const Box& box) {
    const Vec3 size = box.size();
    return size.x * size.y * size.z;
}

/// The cell of a place in the box; its coordinates are in [0, 1].
std::size_t cell_at(const Vec3& place) {
    std::size_t cell = 0;
    for (int axis = 2; axis >= 0; --axis) {
        constexpr auto side = static_cast<double>(EmissionGrid::side);
        const double number = std::clamp(std::floor(place[axis] * side), 0.0, side - 1);
        cell = cell * EmissionGrid::side + static_cast<std::size_t>(number);
    }
    return cell;
}

/// A point of one cell, and its density per volume.
struct PlaceInVolume {
    Vec3 position;
    double density;
};

double cell_density(const MediaBox& e, std::size_t cell) {
    return e.grid->chance(cell) * EmissionGrid::count / volume_of(e.box);
}

PlaceInVolume draw_place(const MediaBox& e, Vec2 u) {
    constexpr auto side = EmissionGrid::side;
    const std::size_t cell = e.grid->draw(u.x);
    const Vec3 corner(static_cast<double>(cell % side), static_cast<double>(cell / side % side),
                      static_cast<double>(cell / (side * side)));
    const Vec3 within(u.x, u.y, second_number(u.y));
    return {e.box.low + (corner + within) / static_cast<double>(side) * e.box.size(),
            cell_density(e, cell)};
}

/// The part of a ray inside the box; empty if the ray misses it.
Interval chord(const Box& box, const Vec3& from, const Vec3& direction) {
    return clip({from, direction}, box, {});
}

/// The bounding sphere of the box as seen from a point.
class BallView {
public:
    BallView(const MediaBox& e, const Vec3& from) : middle_(e.box.centre() - from) {
        const double radius = 0.5 * length(e.box.size()), distance = length(middle_);
        share_ = distance < near_volume * radius ? by_direction : 0;
        if (!(distance > radius)) return;
        const double sine = radius / distance;
        widest_ = sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
        middle_ /= distance;
    }

    /// Fraction of the points that are drawn by direction.
    double share() const { return share_; }
    /// Density per steradian in the cone to the sphere.
    double density() const { return 1 / (2 * pi * widest_); }
    Vec3 draw(const Vec2& u) const {
        const double versine = u.x * widest_, cosine = 1 - versine;
        const double sine = std::sqrt(versine * (2 - versine)), angle = 2 * pi * u.y;
        const Vec3 pole = widest_ < everywhere ? middle_ : Vec3(0, 0, 1);
        const auto [x, y] = perpendiculars(pole);
        return cosine * pole + sine * on_circle(angle, x, y);
    }

private:
    static constexpr double everywhere = 2;

    Vec3 middle_;
    double widest_ = everywhere;  ///< 1 - cosine of the cone's half angle
    double share_ = 0;
};

}  // namespace

EmissionGrid::EmissionGrid(const std::array<double, count>& brightness, double least)
    : brightness_(brightness) {
    double sum = 0;
    for (const double each : brightness) sum += each;
    double until = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double even = 1.0 / count;
        const double own = sum > 0 ? brightness[i] / sum : even;
        until_[i] = until += in_any_cell * even + (1 - in_any_cell) * own;
    }
    until_.back() = 1;
    mean_ = std::fmax(sum / count, least);
}

double EmissionGrid::chance(std::size_t cell) const {
    return until_[cell] - (cell == 0 ? 0 : until_[cell - 1]);
}

std::size_t EmissionGrid::draw(double& u) const {
    const auto found =
        static_cast<std::size_t>(std::ranges::upper_bound(until_, u) - until_.begin());
    const std::size_t cell = std::min(found, count - 1);
    const double before = cell == 0 ? 0 : until_[cell - 1];
    u = std::clamp((u - before) / chance(cell), 0.0, below_1);
    return cell;
}

LightBounds bounds(const MediaBox& e) {
    LightBounds result;
    result.box = e.box;
    result.centre = e.box.centre();
    result.radius = 0.5 * length(e.box.size());
    result.intensity = e.grid->mean() * volume_of(e.box);
    result.luminance = luminance(e.radiance);
    return result;
}

double unoccluded(const MediaBox& e, const Receiver& point) {
    return irradiance(light_proxy(bounds(e)), point);
}

std::optional<LightPoint> sample(const MediaBox& e, const Vec3& from, const Vec2& u) {
    const BallView view(e, from);
    const double share = view.share();
    Vec3 direction;
    Interval inside;
    double distance, by_place;
    if (u.x < share) {
        direction = view.draw({u.x / share, u.y});
        inside = chord(e.box, from, direction);
        if (!(inside.max > inside.min)) return {};
        distance = inside.min + (inside.max - inside.min) * second_number(u.y);
        const Vec3 part = (from + distance * direction - e.box.low) / e.box.size();
        by_place = cell_density(e, cell_at(part));
    } else {
        const PlaceInVolume place = draw_place(e, {(u.x - share) / (1 - share), u.y});
        const Vec3 offset = place.position - from;
        distance = length(offset);
        direction = offset / distance;
        if (share > 0) inside = chord(e.box, from, direction);
        by_place = place.density;
    }
    if (!(distance > 0)) return {};
    double density = (1 - share) * by_place * distance * distance;
    if (share > 0) {
        if (!(inside.max > inside.min)) return {};
        density += share * view.density() / (inside.max - inside.min);
    }
    return LightPoint{from + distance * direction, direction, distance, density};
}

double emitted_about(const MediaBox& e, const Vec3& point) {
    return e.grid->brightness(cell_at((point - e.box.low) / e.box.size()));
}

EmittedRay emit(const MediaBox& e, const EmissionDraw& u) {
    const PlaceInVolume place = draw_place(e, u.where);
    const double height = 1 - 2 * u.direction.x,
                 across = std::sqrt(std::fmax(1 - height * height, 0)),
                 angle = 2 * pi * u.direction.y;
    const Vec3 towards(across * on_circle(angle), height);
    return {{place.position, towards}, towards, place.density / (4 * pi), place.density};
}

double area_of_equal_light(const MediaBox& e) {
    const double diagonal = length(e.box.size());
    return diagonal > 0 ? 4 * volume_of(e.box) / diagonal : 0;
}

}  // namespace candelabra
