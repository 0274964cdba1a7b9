// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera.h"

#include "base/circle.h"
#include "base/degrees.h"
#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace candelabra {

namespace {

/// Fields that all cameras share; some cameras have others before or behind them.
template <class T, std::size_t N = 0, std::size_t M = 0>
consteval auto camera_schema(std::string_view name, ItemText text,
                             const std::array<Field<T>, N>& before = {},
                             const std::array<Field<T>, M>& behind = {}) {
    using F = Field<T>;
    const std::array<F, 15> common = {
        F{"location", &T::location, item, "where it stands"},
        F{"direction", &T::direction, item,
          "towards the middle of the picture; its length is the distance of the "
          "picture plane (default z)"},
        F{"right", &T::right, item,
          "from the left edge of the picture to the right (default 1.33 x; from `#version 3.8` "
          "on as wide as the picture)"},
        F{"up", &T::up, item, "from the bottom of the picture to the top (default y)"},
        F{"sky", &T::sky, item, "what look_at keeps upright"},
        F{"look_at", &T::look_at, item, "the point in the middle of the picture"},
        F{"aperture", &T::aperture, item,
          "four times the radius of the lens: what is not at the focal point is blurred",
          at_least(0)},
        F{"blur_samples", &T::blur_samples, item,
          "rays for each pixel of a blurred picture: at most, or at least", between(0, 1000000)},
        maybe(F{"max_blur_samples", &T::max_blur_samples, following, "rays at most, after a comma",
                between(0, 1000000)}),
        F{"focal_point", &T::focal_point, item,
          "a point at the distance that is sharp (default: as far as direction is long)"},
        F{"variance", &T::variance, item,
          "greatest variance of a blurred pixel's mean; 0: all rays are made", at_least(0)},
        F{"confidence", &T::confidence, item,
          "confidence with which the estimate of `variance` must hold, below 1", Range{0, 1, true}},
        F{"shutter", &T::shutter, item,
          "how far the clock runs on while the picture is taken: what it moves is blurred",
          at_least(0)},
        maybe(F{"moments", &T::moments, following,
                "moments of that time that the picture is made of, after a comma",
                between(1, 1000)}),
        F{"angle", &T::angle, item,
          "degrees from the left edge to the right; 0: as without, but the distance of look_at "
          "decides the width of parallel rays",
          at_least(0)}};
    Schema<T, N + common.size() + M> result{name, text, {}};
    auto to = std::copy(before.begin(), before.end(), result.fields.begin());
    to = std::copy(common.begin(), common.end(), to);
    std::copy(behind.begin(), behind.end(), to);
    return result;
}

}  // namespace

const ItemInfo Perspective::vocabulary = described<Perspective>([] {
    return camera_schema<Perspective>(
        "perspective",
        {"All rays start at the camera.",
         "camera { perspective location <0, 2, -6> look_at 0.5*y angle 50 }",
         "camera { location <0, 2, -6> direction 2*z right 4/3*x up y sky y look_at 0.5*y }",
         "camera { location <0, 2, -6> look_at 0.5*y aperture 1.2 focal_point 0.5*y blur_samples "
         "60 }",
         "camera { location <0, 2, -6> look_at 0.5*y aperture 1.2 focal_point 0.5*y blur_samples "
         "20, 60 confidence 0.9 variance 1/100 }",
         "camera { location <0, 2, -6> look_at 0.5*y normal { ripples 0.3 scale 0.2 } }",
         "camera { location <-1 + clock, 2, -6> look_at 0.5*y shutter 1, 12 }"});
});

const ItemInfo Orthographic::vocabulary = described<Orthographic>([] {
    return camera_schema<Orthographic>(
        "orthographic", {"All rays are parallel.",
                         "camera { orthographic location <0, 2, -6> look_at 0.5*y angle 50 }"});
});

const ItemInfo Fisheye::vocabulary = described<Fisheye>([] {
    return camera_schema<Fisheye>(
        "fisheye", {"A round picture; equal angles are equal lengths from its middle.",
                    "camera { fisheye location <0, 2, -3> look_at 0.5*y angle 180 }"});
});

const ItemInfo UltraWideAngle::vocabulary = described<UltraWideAngle>([] {
    return camera_schema<UltraWideAngle>(
        "ultra_wide_angle",
        {"Wide angles, with edges that bend.",
         "camera { ultra_wide_angle location <0, 2, -3> look_at 0.5*y angle 120 }"});
});

const ItemInfo Omnimax::vocabulary = described<Omnimax>([] {
    return camera_schema<Omnimax>(
        "omnimax", {"A wide picture for a dome.",
                    "camera { omnimax location <0, 2, -3> look_at 0.5*y angle 180 }"});
});

const ItemInfo Panoramic::vocabulary = described<Panoramic>([] {
    return camera_schema<Panoramic>(
        "panoramic", {"Half a turn; upright lines stay straight.",
                      "camera { panoramic location <0, 1, -2> look_at 0.5*y angle 180 }"});
});

const ItemInfo CylinderCamera::vocabulary = described<CylinderCamera>([] {
    return camera_schema<CylinderCamera>(
        "cylinder",
        {"The picture on a cylinder: 1 upright, 2 lying, 3 and 4 with rays from its axis.",
         "camera { cylinder 1 location <0, 1, -2> look_at 0.5*y angle 180 }",
         "camera { cylinder 2 location <0, 1, -2> look_at 0.5*y angle 90 }",
         "camera { cylinder 3 location <0, 1, -2> look_at 0.5*y angle 180 }",
         "camera { cylinder 4 location <0, 1, -2> look_at 0.5*y angle 90 }"},
        std::array{Field<CylinderCamera>{"type", &CylinderCamera::type, positional, "1 to 4",
                                         between(1, 4)}});
});

const ItemInfo MeshCamera::vocabulary = described<MeshCamera>([] {
    return camera_schema<MeshCamera>("mesh_camera",
                                     {"Rays from the faces of meshes.",
                                      "camera { mesh_camera { 1, 0 mesh { triangle { <-3, 0, -4>, "
                                      "<3, 0, -4>, <0, 4, -4> } } } direction z }"});
});

const ItemInfo UserDefinedCamera::vocabulary = described<UserDefinedCamera>([] {
    return camera_schema<UserDefinedCamera>(
        "user_defined", {"Rays by functions of the place in the picture.",
                         "camera { user_defined location <0, 1, -4> direction { function { "
                         "sin(4*x) } function { y - x*x } function { cos(4*x) } } }"});
});

const ItemInfo SphericalCamera::vocabulary = described<SphericalCamera>([] {
    return camera_schema<SphericalCamera>(
        "spherical",
        {"All around: longitude to the right, latitude upwards.",
         "camera { spherical location <0, 1, -2> look_at 0.5*y }",
         "camera { spherical location <0, 1, -2> look_at 0.5*y angle 180 90 }"},
        std::array<Field<SphericalCamera>, 0>{},
        std::array{maybe(Field<SphericalCamera>{
            "vertical_angle", &SphericalCamera::vertical_angle, following,
            "degrees from the bottom to the top; half of the angle when left out"})});
});

namespace {

/// Default minimum number of rays of a blurred pixel, as in POV-Ray: fewer are too often equal by
/// chance.
int usual_blur_samples(int most) {
    constexpr int few = 4, usual = 7;
    return most >= usual ? usual : std::min(most, few);
}

// Lens of each camera.
Lens lens_of(const Perspective&) { return Lens::flat; }
Lens lens_of(const Orthographic&) { return Lens::parallel; }
Lens lens_of(const Fisheye&) { return Lens::fisheye; }
Lens lens_of(const UltraWideAngle&) { return Lens::ultra_wide; }
Lens lens_of(const Omnimax&) { return Lens::omnimax; }
Lens lens_of(const Panoramic&) { return Lens::panoramic; }
Lens lens_of(const CylinderCamera& camera) {
    return static_cast<Lens>(static_cast<int>(Lens::cylinder1) + camera.type - 1);
}
Lens lens_of(const SphericalCamera&) { return Lens::spherical; }
Lens lens_of(const MeshCamera&) { return Lens::mesh; }
Lens lens_of(const UserDefinedCamera&) { return Lens::functions; }

/// `sizes`: the visible width of parallel rays may depend on the distance from the camera to
/// look_at.
Projection untransformed(const View& view, Lens lens, bool sizes = true) {
    const bool parallel = lens == Lens::parallel;
    const bool flat = parallel || lens == Lens::flat;
    Projection f{
        view.location,
        view.direction.value_or(Vec3(0, 0, 1)),
        view.right.value_or(Vec3(view.aspect, 0, 0)),
        view.up.value_or(Vec3(0, 1, 0)),
        parallel || lens == Lens::cylinder3 || lens == Lens::cylinder4 || lens == Lens::mesh,
        lens};
    const bool narrows = view.angle && *view.angle > 0;
    f.angle = (narrows ? *view.angle : lens == Lens::spherical ? 360 : 90) * radians_per_degree;
    f.vertical_angle = f.angle / 2;
    // As in POV-Ray, there is nothing to see then.
    if (narrows && flat && f.direction == Vec3(0)) f.right = f.up = Vec3(0);
    if (narrows && flat)
        f.direction = unit(f.direction) *
                      (0.5 * length(f.right) / math::tan(0.5 * *view.angle * radians_per_degree));
    if (view.look_at) {
        // Where up is parallel to the direction, POV-Ray's picture is mirrored. So is one with a
        // `right` to the left that looks along the sky.
        const double handedness = dot(cross(f.up, f.direction), f.right) > 0 ? 1 : -1;
        const Vec3 ahead = unit(*view.look_at - view.location);
        const Vec3 side = unit(cross(view.sky, ahead));
        f.direction = ahead * length(f.direction);
        if (side != Vec3(0)) {
            f.right = handedness * length(f.right) * side;
            f.up = length(f.up) * unit(cross(ahead, side));
        } else {
            f.up = length(f.up) * unit(cross(ahead, f.right));
            f.right *= handedness;
        }
    }
    if (sizes && parallel && ((!view.up && !view.right) || view.angle)) {
        const double ahead = length(f.direction);
        const double size =
            ahead > 0 ? length(view.look_at.value_or(Vec3(0, 0, 1)) - view.location) / ahead : 1;
        f.right *= size;
        f.up *= size;
    }
    return f;
}

const View& view_of(const Camera& camera) {
    return std::visit([](const auto& c) -> const View& { return c; }, camera);
}

View& view_of(Camera& camera) {
    return std::visit([](auto& c) -> View& { return c; }, camera);
}

/// As in POV-Ray, only z of the camera's location and direction counts, and transforms do not move
/// the meshes.
Handle<MeshLens> lens_of_meshes(const MeshCamera& camera, const Projection& placed) {
    return make_handle<MeshLens>(camera.from ? *camera.from : MeshRays(), placed.location.z,
                                 placed.direction.z < 0);
}

}  // namespace

void settle(Camera& camera) {
    const Lens lens = std::visit([](const auto& c) { return lens_of(c); }, camera);
    View& view = view_of(camera);
    const bool parallel = lens == Lens::parallel;
    const bool narrows = view.angle && (parallel || lens == Lens::flat);
    const bool turns = view.look_at && *view.look_at != view.location;
    if (!narrows && !turns && !parallel) return;
    const Projection now = untransformed(view, lens, false);
    view.direction = now.direction;
    view.right = now.right;
    view.up = now.up;
    view.look_at.reset();
    if (narrows) view.angle.reset();
}

std::string problem(const Camera& camera) {
    const View& view = view_of(camera);
    if (view.look_at && *view.look_at == view.location)
        return "`look_at` must not be the camera's own location";
    const Lens lens = std::visit([](const auto& c) { return lens_of(c); }, camera);
    if (lens == Lens::functions && view.angle)
        return "`angle` has no place beside the functions of a `user_defined` camera";
    if (view.angle && *view.angle >= 180 && (lens == Lens::flat || lens == Lens::parallel))
        return "`angle` of a flat picture must be below 180 degrees";
    return {};
}

bool is_flattened(const Camera& camera) {
    const Lens lens = std::visit([](const auto& c) { return lens_of(c); }, camera);
    if (lens == Lens::functions) return false;
    const Projection f = untransformed(view_of(camera), lens);
    if (lens != Lens::spherical) return dot(cross(f.right, f.up), f.direction) == 0;
    return f.right == Vec3(0) || f.up == Vec3(0) || f.direction == Vec3(0);
}

Projection projection(const Camera& camera) {
    const View& view = view_of(camera);
    Projection f =
        untransformed(view, std::visit([](const auto& c) { return lens_of(c); }, camera));
    if (const auto* around = std::get_if<SphericalCamera>(&camera);
        around && around->vertical_angle)
        f.vertical_angle = *around->vertical_angle * radians_per_degree;
    if (view.aperture > 0 && view.blur_samples > 0) {
        const bool both = view.max_blur_samples > 0;
        const int most = both ? view.max_blur_samples : view.blur_samples;
        f.blur = {both ? std::min(most, view.blur_samples) : usual_blur_samples(most), most,
                  view.variance, view.confidence};
        // As in POV-Ray, scaling the camera changes neither its lens nor its focal distance.
        f.lens_radius = 0.25 * view.aperture;
        f.lens_shape = LensShape(view.bokeh);
        f.focal_distance = length(view.focal_point ? *view.focal_point - f.location : Vec3(0));
        if (f.focal_distance == 0) f.focal_distance = length(f.direction);
    }
    f.location = view.transform.point(f.location);
    f.direction = view.transform.direction(f.direction);
    f.right = view.transform.direction(f.right);
    f.up = view.transform.direction(f.up);
    if (const auto* meshes = std::get_if<MeshCamera>(&camera)) f.mesh = lens_of_meshes(*meshes, f);
    if (const auto* user = std::get_if<UserDefinedCamera>(&camera)) {
        f.from = user->from;
        f.towards = user->towards;
        f.parallel = f.from.given();
        if (f.from.given()) f.location = f.from.at(0, 0);
        if (f.towards.given()) f.direction = f.towards.at(0, 0);
    }
    return f;
}

std::optional<double> pixel_aspect(const Projection& f, int width, int height) {
    const double across = length(f.right) / width, along = length(f.up) / height;
    const bool even = f.lens == Lens::flat || f.lens == Lens::parallel || f.lens == Lens::fisheye;
    if (!even || !(across > 0 && along > 0)) return std::nullopt;
    return across / along;
}

namespace {

/// Quantile of the chi-squared distribution with `count` degrees of freedom, by the cube root rule
/// of Wilson and Hilferty (1931); the normal quantile is Abramowitz and Stegun's 26.2.23.
double chi_squared(int count, double probability) {
    const double tail = std::clamp(std::min(probability, 1 - probability), 1e-12, 0.5);
    const double t = std::sqrt(-2 * math::log(tail));
    const double z = t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                             (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    const double spread = 2.0 / (9 * std::max(count, 1));
    const double root = 1 - spread + (probability < 0.5 ? -z : z) * std::sqrt(spread);
    return std::max(count, 1) * root * root * root;
}

/// Direction at an angle from the axis of a round picture, towards (p, q).
Vec3 around_middle(const Projection& f, double angle, double p, double q) {
    const double radius = std::sqrt(p * p + q * q);
    if (radius == 0) return unit(f.direction);
    return math::sin(angle) / radius * (p * unit(f.right) + q * unit(f.up)) +
           math::cos(angle) * unit(f.direction);
}

Vec3 fisheye(const Projection& f, double u, double v) {
    const double p = 2 * u * length(f.right), q = 2 * v * length(f.up);
    const double radius = std::sqrt(p * p + q * q);
    return radius > 1 ? Vec3(0) : around_middle(f, 0.5 * radius * f.angle, p, q);
}

/// The film's shape and the lens's polynomial are those of the Omnimax system, as in POV-Ray.
Vec3 omnimax(const Projection& f, double u, double v) {
    constexpr double film = 1.283458;
    const double aspect = length(f.right) / length(f.up);
    double x = 2 * u, y = 2 * v;
    if (aspect > film) {
        x *= aspect / film;
        y = (y - 1) / film + 1;
    } else if (aspect > 1) {
        y = (y - 1) / aspect + 1;
    } else {
        y /= aspect;
    }
    const double r = std::sqrt(x * x + y * y);
    if (r > 1) return Vec3(0);
    const double angle = 1.411269 * r - 0.09439 * r * r * r + 0.25674 * r * r * r * r * r;
    if (r > 0 && y / r * math::sin(angle) < -math::cos(angle)) return Vec3(0);
    return around_middle(f, angle, x, y);
}

/// Rotates about an axis of unit length, in the same sense as `rotate`.
Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
    const Vec3 along = dot(axis, v) * axis;
    return along + math::cos(angle) * (v - along) + math::sin(angle) * cross(axis, v);
}

/// As in POV-Ray the vectors need not be perpendicular: they are axes of rotation.
Vec3 spherical(const Projection& f, double u, double v) {
    if (f.right == Vec3(0) || f.up == Vec3(0)) return Vec3(0);
    const Vec3 lifted = turned(unit(f.direction), unit(f.right), -v * f.vertical_angle);
    return turned(lifted, unit(f.up), u * f.angle);
}

bool all_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A zero or non-finite vector sends no ray, as in POV-Ray.
Ray by_functions(const Projection& f, double u, double v) {
    const Vec3 start = f.from.given() ? f.from.at(u, v) : f.location;
    const Vec3 towards = f.towards.given() ? f.towards.at(u, v) : f.direction;
    if (!all_finite(start) || !all_finite(towards)) return {f.location, Vec3(0)};
    return {start, unit(towards)};
}

}  // namespace

double BlurRays::allowed(int rays) const {
    if (rays >= most) return std::numeric_limits<double>::infinity();
    // As in POV-Ray, a variance of 0 requires all rays, even where the first ones are equal.
    if (rays < least || variance <= 0) return -1;
    return variance * chi_squared(rays, confidence) / chi_squared(most - 1, confidence);
}

Ray Projection::through_lens(const Ray& ray, Vec2 place) const {
    const Vec3 ahead = unit(direction);
    const double cosine = dot(ray.direction, ahead);
    if (cosine <= 0) return ray;
    const Vec3 sharp = ray.at(focal_distance / cosine);
    const auto from = [&](const Vec3& start) { return Ray{start, unit(sharp - start)}; };
    if (lens_shape.is_round()) {
        const auto [x, y] = perpendiculars(ahead);
        const double radius = lens_radius * std::sqrt(place.x),
                     angle = 2 * std::numbers::pi * place.y;
        return from(ray.origin + radius * on_circle(angle, x, y));
    }
    const Vec2 point = lens_radius * lens_shape.point(place);
    return from(ray.origin + point.x * unit(right) + point.y * unit(up));
}

Ray Projection::ray(double u, double v) const {
    if (lens == Lens::flat || lens == Lens::mesh)
        return {location, unit(direction + u * right + v * up)};
    const double width = length(right);
    const double a = u * angle, b = width > 0 ? v * angle * length(up) / width : 0;
    const Vec3 side = unit(right), above = unit(up), ahead = unit(direction);
    const auto from_here = [&](const Vec3& towards) { return Ray{location, unit(towards)}; };
    switch (lens) {
        case Lens::flat:
        case Lens::mesh:
            break;  // above
        case Lens::parallel:
            return {location + u * right + v * up, ahead};
        case Lens::fisheye:
            return from_here(fisheye(*this, u, v));
        case Lens::ultra_wide:
            if (width == 0) return from_here(Vec3(0));
            return from_here(math::sin(a) * side + math::sin(b) * above +
                             math::cos(a) * math::cos(b) * ahead);
        case Lens::omnimax:
            return from_here(omnimax(*this, u, v));
        case Lens::panoramic: {
            const double around = std::numbers::pi * (0.5 - u);
            return from_here(math::cos(around) * right + math::tan(std::numbers::pi * v) * up +
                             math::sin(around) * direction);
        }
        case Lens::cylinder1:
            return from_here(math::sin(a) * side + v * up + math::cos(a) * ahead);
        case Lens::cylinder2:
            return from_here(u * right + math::sin(v * angle) * above +
                             math::cos(v * angle) * ahead);
        case Lens::cylinder3:
            return {location + v * up, unit(math::sin(a) * side + math::cos(a) * ahead)};
        case Lens::cylinder4:
            return {location + u * right,
                    unit(math::sin(v * angle) * above + math::cos(v * angle) * ahead)};
        case Lens::spherical:
            return from_here(spherical(*this, u, v));
        case Lens::functions:
            return by_functions(*this, u, v);
    }
    return {location, ahead};
}

Vec3 Projection::normal_place(double u, double v) const {
    const double width = length(right), height = length(up);
    switch (lens) {
        case Lens::fisheye:
        case Lens::omnimax: {
            const Vec3 towards = ray(u, v).direction;
            const double away = math::acos(dot(unit(direction), towards));
            const double around =
                math::atan2(dot(up, towards) / height, dot(right, towards) / width);
            // Counted from a quarter turn below, as in POV-Ray.
            const bool low = around < -0.5 * std::numbers::pi;
            return {low ? around + 2 * std::numbers::pi : around, away, 0};
        }
        case Lens::ultra_wide:
            return {u * angle, v * angle * height / width, 0};
        case Lens::panoramic:
            return {std::numbers::pi * (0.5 - u), std::numbers::pi * v, 0};
        case Lens::cylinder1:
        case Lens::cylinder3:
            return {u * angle, v * height, 0};
        case Lens::cylinder2:
        case Lens::cylinder4:
            return {u * width, v * angle, 0};
        case Lens::spherical:
            return {u * angle, v * vertical_angle, 0};
        case Lens::flat:
        case Lens::parallel:
        case Lens::mesh:
        case Lens::functions:
            break;
    }
    return {u, v, 0};
}

}  // namespace candelabra
