// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/orbit.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr double highest = 89;  ///< degrees
constexpr double min_factor = 1e-4, greatest_factor = 1e4;

/// The axis of the scene that is vertical in the picture.
Vec3 upright(const Projection& camera) {
    int most = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(camera.up[i]) > std::abs(camera.up[most])) most = i;
    Vec3 axis(0);
    axis[most] = camera.up[most] < 0 ? -1 : 1;
    return axis;
}

Vec3 spun(const Vec3& v, const Vec3& axis, double angle) {
    const Vec3 along = dot(axis, v) * axis;
    return along + math::cos(angle) * (v - along) + math::sin(angle) * cross(axis, v);
}

/// Angle of the camera above the point, in degrees.
double elevation(const Projection& camera) {
    const double sine = -dot(unit(camera.direction), upright(camera));
    return math::asin(std::clamp(sine, -1.0, 1.0)) / radians_per_degree;
}

/// A short number; -0 becomes 0.
float shortened(double value) {
    constexpr double digits = 1e6;
    return static_cast<float>(std::round(value * digits) / digits + 0.0);
}

std::string vector_script(const Vec3& v) {
    return message("<", shortened(v.x), ", ", shortened(v.y), ", ", shortened(v.z), ">");
}

/// The lens with its angles, if it has any.
std::string lens_script(const Projection& camera) {
    const float across = shortened(camera.angle / radians_per_degree);
    switch (camera.lens) {
        case Lens::flat:
        case Lens::mesh:
        case Lens::functions:
            return "perspective";
        case Lens::parallel:
            return "orthographic";
        case Lens::fisheye:
            return message("fisheye angle ", across);
        case Lens::ultra_wide:
            return message("ultra_wide_angle angle ", across);
        case Lens::omnimax:
            return "omnimax";
        case Lens::panoramic:
            return "panoramic";
        case Lens::spherical:
            return message("spherical angle ", across, " ",
                           shortened(camera.vertical_angle / radians_per_degree));
        case Lens::cylinder1:
        case Lens::cylinder2:
        case Lens::cylinder3:
        case Lens::cylinder4:
            break;
    }
    const int type = 1 + static_cast<int>(camera.lens) - static_cast<int>(Lens::cylinder1);
    return message("cylinder ", type, " angle ", across);
}

/// A picture is not known as text any more, so the place for it is marked.
std::string bokeh_script(const LensShape& shape) {
    if (shape.is_picture()) return "  // bokeh { pigment { ... } } as in the scene\n";
    if (shape.is_round()) return {};
    return message("  bokeh { blades ", shape.blades().blades, " angle ",
                   shortened(shape.blades().angle), " }\n");
}

std::string blur_script(const Projection& camera) {
    if (!camera.blurs()) return {};
    constexpr double apertures = 4;  // per radius
    const Vec3 sharp = camera.location + camera.focal_distance * unit(camera.direction);
    return message("  aperture ", shortened(apertures * camera.lens_radius), " blur_samples ",
                   camera.blur.least, ", ", camera.blur.most, "\n  focal_point ",
                   vector_script(sharp), " variance ", static_cast<float>(camera.blur.variance),
                   " confidence ", static_cast<float>(camera.blur.confidence), "\n",
                   bokeh_script(camera.lens_shape));
}

}  // namespace

void Orbit::turn(const Sight& given, double right, double up) {
    const double level = elevation(given.camera);
    constexpr double circle = 360;
    right_ = std::remainder(right_ + right, circle);
    // A camera that already looks from above the limit may stay there.
    up_ = std::clamp(up_ + up, std::min(-highest - level, 0.0), std::max(highest - level, 0.0));
    moved_ = true;
}

void Orbit::pan(const Sight& given, double right, double up) {
    const Sight now = place(given);
    // Rays from a single point diverge.
    const double spread = now.camera.parallel ? 1 : now.distance / length(now.camera.direction);
    shift_ += spread * (right * now.camera.right + up * now.camera.up);
    moved_ = true;
}

void Orbit::approach(double factor) {
    if (!(factor > 0)) return;
    factor_ = std::clamp(factor_ * factor, min_factor, greatest_factor);
    moved_ = true;
}

Sight Orbit::place(const Sight& given) const {
    if (!moved_) return given;
    Sight now = given;
    Projection& camera = now.camera;
    const Vec3 axis = upright(camera), aside = unit(camera.right);
    const Vec3 back = -unit(camera.direction);
    const Vec3 point = camera.location - given.distance * back + shift_;
    // Angles follow the movement of the camera, independent of the scene's handedness.
    const double to_right = dot(cross(axis, back), aside) < 0 ? -right_ : right_;
    const double upwards = dot(cross(aside, back), axis) < 0 ? -up_ : up_;
    const auto turned_by = [&](const Vec3& v) {
        return spun(spun(v, aside, upwards * radians_per_degree), axis,
                    to_right * radians_per_degree);
    };
    camera.direction = turned_by(camera.direction);
    camera.right = turned_by(camera.right);
    camera.up = turned_by(camera.up);
    if (camera.parallel) {
        camera.right *= factor_;
        camera.up *= factor_;
    } else {
        now.distance = given.distance * factor_;
        // The plane of focus stays in place.
        const double sharp = camera.focal_distance - given.distance + now.distance;
        camera.focal_distance = sharp > 0 ? sharp : camera.focal_distance * factor_;
    }
    camera.location = point - now.distance * unit(camera.direction);
    return now;
}

bool can_orbit(const Projection& camera) {
    return camera.lens != Lens::mesh && !camera.mesh && camera.lens != Lens::functions;
}

std::string camera_script(const Sight& sight) {
    const Projection& camera = sight.camera;
    const bool looks = camera.lens == Lens::flat;
    std::string text = message("camera {\n  ", lens_script(camera), "\n  location ",
                               vector_script(camera.location), "\n");
    const bool square = std::abs(dot(unit(camera.right), unit(camera.up))) < 1e-6 &&
                        std::abs(dot(unit(camera.right), unit(camera.direction))) < 1e-6 &&
                        std::abs(dot(unit(camera.up), unit(camera.direction))) < 1e-6;
    if (looks && square) {
        const double side = dot(cross(camera.up, camera.direction), camera.right) < 0 ? -1 : 1;
        // The vertical axis of the scene gives the same picture as the picture's own.
        const Vec3 axis = upright(camera);
        const bool level = std::abs(dot(unit(camera.right), axis)) < 1e-6 &&
                           std::abs(dot(unit(camera.direction), axis)) < 1 - 1e-6;
        text += message(
            "  right ", shortened(side * length(camera.right)), "*x up ",
            shortened(length(camera.up)), "*y direction ", shortened(length(camera.direction)),
            "*z\n  sky ", vector_script(level ? axis : unit(camera.up)), "\n  look_at ",
            vector_script(camera.location + sight.distance * unit(camera.direction)), "\n");
    } else {
        text += message("  direction ", vector_script(camera.direction), "\n  right ",
                        vector_script(camera.right), "\n  up ", vector_script(camera.up), "\n");
    }
    return text + blur_script(camera) + "}\n";
}

}  // namespace candelabra
