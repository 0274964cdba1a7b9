// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/aimed_web.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

/// Shortest part of c0 across the aim that is taken for a direction.
constexpr double least_across = 1e-6;

Vec3 across(const WebPlace& place) {
    const Vec3 down = unit(place.aim), c0 = unit(place.c0);
    return c0 - dot(c0, down) * down;
}

/// Greatest angle to the aim at which an entry of the table is above a share of the greatest, and
/// one entry more, since intensities between entries are interpolated.
double widest(const PhotometricWeb& web, double least) {
    double cosine = 1;
    const auto& rows = web.vertical();
    const auto& planes = web.horizontal();
    const auto lit = [&](std::size_t plane, std::size_t row) {
        return web.intensity(WebAngles{rows[row], planes[plane]}) > least;
    };
    for (std::size_t plane = 0; plane < planes.size(); ++plane)
        for (std::size_t row = 0; row < rows.size(); ++row) {
            bool near = false;
            for (std::size_t p = plane > 0 ? plane - 1 : 0; p <= plane + 1 && p < planes.size();
                 ++p)
                for (std::size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < rows.size(); ++r)
                    near = near || lit(p, r);
            if (!near) continue;
            cosine = std::min(cosine, -direction_of(web.type(), {rows[row], planes[plane]}).z);
        }
    // The poles of the other types lie aside, and a cell may reach farther than its corners.
    const double slack = web.type() == WebType::c ? 0 : 0.1;
    return std::fmin(math::acos(std::clamp(cosine, -1.0, 1.0)) + slack, std::numbers::pi);
}

}  // namespace

void turn(WebPlace& place, const Transform& transform) {
    place.aim = transform.direction(place.aim);
    place.c0 = transform.direction(place.c0);
    if (transform.determinant() < 0) place.mirrored = !place.mirrored;
}

double tilt_factor(const WebPlace& place) {
    if (!place.tilt || !place.tilt->follows_aim()) return 1;
    const double down = std::clamp(-unit(place.aim).y, -1.0, 1.0);
    return factor_of_tilt(*place.tilt, math::acos(down) * (180 / std::numbers::pi));
}

bool has_axes(const WebPlace& place) {
    return place.aim != Vec3(0) && place.c0 != Vec3(0) && length(across(place)) > least_across;
}

AimedWeb::AimedWeb(const WebPlace& place)
    : web_(place.web),
      greatest_(web_->greatest()),
      dark_(widest(*web_, 0)),
      bright_(widest(*web_, 0.5 * greatest_)) {
    set_axes(place);
}

AimedWeb::AimedWeb(const AimedWeb& same, const WebPlace& place) : AimedWeb(same) {
    set_axes(place);
}

void AimedWeb::set_axes(const WebPlace& place) {
    x_ = unit(across(place));
    // In the space of the scene, which is left-handed, C90 lies at C0 times up.
    y_ = cross(x_, place.mirrored ? unit(place.aim) : -unit(place.aim));
    z_ = -unit(place.aim);
}

}  // namespace candelabra
