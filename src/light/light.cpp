// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/light.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "base/transform.h"
#include "light/spreading.h"
#include "photometry/light_colour.h"
#include "photometry/web_fields.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

const ItemInfo PointLight::vocabulary = described<PointLight>([] {
    using F = Field<PointLight>;
    using Web = WebFields<PointLight>;
    return schema<PointLight>(
        "light_source",
        {"A light: a point, a cone, a beam, or a grid of points.",
         "light_source { <-2, 4, -3>, rgb 1 }", "light_source { <-2, 4, -3>, rgb <1, 0.6, 0.3> }",
         "light_source { <-2, 4, -3>, rgb 1 shadowless }",
         "light_source { <-2, 4, -3>, rgb 1.5 spotlight point_at 0 radius 12 falloff 20 }",
         "light_source { <-2, 4, -3>, rgb 1.5 spotlight point_at 0 radius 5 falloff 25 tightness "
         "10 }",
         "light_source { <-2, 4, -3>, rgb 1 cylinder point_at 0 radius 0.8 falloff 1.2 }",
         "light_source { <-2, 4, -3>, rgb 1 parallel point_at 0 }",
         "light_source { <-2, 4, -3>, rgb 3 fade_distance 2 fade_power 2 }",
         "light_source { <-2, 4, -3>, rgb 1 area_light 2*x, 2*z, 4, 4 }",
         "light_source { <-2, 4, -3>, rgb 1 area_light 2*x, 2*z, 5, 5 adaptive 1 jitter }",
         "light_source { <-2, 4, -3>, rgb 1 area_light 2*x, 2*z, 9, 9 circular orient }",
         "light_source { <-2, 4, -3>, rgb 1 area_light 3*x, 3*z, 9, 9 area_illumination }",
         "light_source { <-2, 4, -3>, rgb 1 media_attenuation on media_interaction off }",
         "light_source { <-2, 4, -3>, rgb 1 looks_like { sphere { 0, 0.2 pigment { rgb 1 } finish "
         "{ ambient 1 } } } }",
         "light_source { <-2, 4, -3>, rgb 1 projected_through { disc { <-1, 2, -1.5>, y, 0.3 } } }",
         "global_settings { photometry { white 100 } } light_source { <-2, 4, -3>, rgb 1 intensity "
         "800 }",
         "global_settings { photometry { white 100 } } light_source { <-2, 4, -3>, rgb 1 flux 3000 "
         "}",
         "global_settings { photometry { white 100 } } light_source { <0, 3, 0>, rgb 1 ies "
         "\"gems.gltf\" profile 0 multiplier 0.5 }"},
        F{"location", &PointLight::location, positional, "where it is"},
        maybe(F{"colour", &PointLight::colour, positional, "colour of the light, of any strength"}),
        chooses("spotlight", &PointLight::beam, cone, "shines in a cone"),
        chooses("cylinder", &PointLight::beam, parallel_beam, "shines in a beam of equal width"),
        F{"parallel", &PointLight::parallel, flag, "all its light has one direction"},
        F{"point_at", &PointLight::point_at, item, "where its axis leads"},
        F{"radius", &PointLight::radius, item,
          "half width of the bright middle: degrees (30), or a length (0.75) of a cylinder"},
        F{"falloff", &PointLight::falloff, item,
          "half width at which there is no more light: degrees (45), or a length (1)"},
        F{"tightness", &PointLight::tightness, item, "how fast it weakens away from the axis"},
        F{"fade_distance", &PointLight::fade_distance, item,
          "distance at which it has its colour, when it fades; 0: it does not, or from "
          "`#version 3.8` on 1 / distance^fade_power"},
        F{"fade_power", &PointLight::fade_power, item,
          "how fast it fades: 2 is nature's way; 0 or less: it does not"},
        F{"intensity", &PointLight::intensity, item,
          "luminous intensity, as candela(1000): it falls with the square of the distance, and the "
          "colour counts as a hue only",
          at_least(0)},
        F{"flux", &PointLight::flux, item,
          "brightness by the luminous flux in all directions, such as lumen(800)", at_least(0)},
        Web::ies, Web::ldt, Web::profile, Web::lamp_set, Web::multiplier, Web::aim, Web::c0,
        Web::mirrored,
        F{"shadowless", &PointLight::shadowless, flag,
          "nothing stops its light, no cone either; gives no highlights"},
        F{"media_attenuation", &PointLight::media_attenuation, flag,
          "fog weakens its light on the way to what it lights"},
        F{"media_interaction", &PointLight::media_interaction, flag,
          "`off`: fog does not weaken its light in any case"},
        F{"area_light", &PointLight::area1, item, "a grid of lights: one side of it"},
        F{"area_side", &PointLight::area2, following, "the other side"},
        F{"area_size1", &PointLight::size1, following, "lights along the first side",
          between(0, 1000)},
        F{"area_size2", &PointLight::size2, following, "lights along the other", between(0, 1000)},
        F{"adaptive", &PointLight::adaptive, item,
          "divisions of the grid before a part whose lights agree is taken as one", at_least(0)},
        F{"jitter", &PointLight::jitter, flag, "moves the lights of the grid at random"},
        F{"circular", &PointLight::circular, flag, "a disc instead of a rectangle"},
        F{"orient", &PointLight::orient, flag, "turns the grid towards each point"},
        F{"area_illumination", &PointLight::area_illumination, flag,
          "each light of the grid lights by itself; otherwise only shadows differ"});
});

namespace {

double smooth(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double cosine_of(double degrees) { return math::cos(degrees * radians_per_degree); }

LightConeShape cone_shape(const PointLight& light) {
    return {axis_of(light), cosine_of(light.radius.value_or(30)),
            cosine_of(light.falloff.value_or(45))};
}

double faded(const PointLight& light, double distance) {
    if (light.fade_power <= 0 || (light.fade_distance == 0 && !light.fades_from_source)) return 1;
    if (light.fade_distance == 0) {
        const double amount = math::pow(distance, -light.fade_power);
        return std::isfinite(amount) ? amount : 0;
    }
    const double share = distance / light.fade_distance, power = light.fade_power;
    const double amount = 2 / (1 + (power == 2 ? share * share : math::pow(share, power)));
    // A negative base has no fractional powers, and with odd powers the divisor may be 0.
    return std::isfinite(amount) ? amount : 0;
}

/// Fraction of a cone's light in a direction at this cosine to the axis.
double in_cone(const PointLight& light, const LightConeShape& shape, double cosine) {
    const double bright = shape.bright, dark = shape.dark;
    if (cosine <= 0 || (bright > 0 && cosine < bright && cosine < dark)) return 0;
    double share = light.tightness == 0 ? 1 : math::pow(cosine, light.tightness);
    if (bright > 0 && cosine < bright) share *= smooth((cosine - dark) / (bright - dark));
    return share;
}

/// Fraction of a beam's light at a distance from its axis.
double in_beam(const PointLight& light, double away) {
    const double bright = light.radius.value_or(0.75), dark = light.falloff.value_or(1);
    if (away >= dark) return 0;
    const double inside = 1 - away / dark;
    double share = light.tightness == 0 ? 1 : math::pow(inside, light.tightness);
    if (bright > 0 && away > bright) share *= smooth(inside / (1 - bright / dark));
    return share;
}

}  // namespace

bool has_flux(const PointLight& light) {
    return !light.along_axis() && light.fades_from_source && light.fade_distance == 0 &&
           light.fade_power == 2;
}

double filled_steradians(const PointLight& light) {
    using std::numbers::pi;
    if (light.web) return light.web->flux() / light.web->greatest();
    if (light.kept_to() != cone) return 4 * pi;
    const LightConeShape shape = cone_shape(light);
    constexpr int parts = 4096;  // even, for Simpson's rule
    // By the angle, in which strong tightness is not as narrow as in its cosine.
    const double edges[] = {0, math::acos(std::clamp(shape.bright, 0.0, 1.0)), pi / 2};
    double sum = 0;
    for (int piece = 0; piece < 2; ++piece) {
        const double step = (edges[piece + 1] - edges[piece]) / parts;
        for (int i = 0; i <= parts; ++i) {
            const auto [sine, cosine] = math::sin_cos(edges[piece] + i * step);
            const double weight = i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2;
            sum += weight * step / 3 * sine * in_cone(light, shape, cosine);
        }
    }
    return 2 * pi * sum;
}

LightCone cone_around(const PointLight& light) {
    if (light.web) {
        const AimedWeb web = light.aimed ? *light.aimed : AimedWeb(light);
        return {web.aim(), math::cos(web.dark())};
    }
    if (light.kept_to() != cone) return all_directions;
    const LightConeShape shape = cone_shape(light);
    const double edge = shape.bright > 0 ? std::fmin(shape.bright, shape.dark) : 0;
    return {shape.axis, std::fmax(edge, 0)};
}

std::string measure(PointLight& light) {
    if (!light.is_measured()) return {};
    if (light.web && light.beam == cone)
        return "a light with a file of intensities has its shape from there: it is no `spotlight`";
    const double greatest = light.web ? light.web->greatest() * light.per_candela : 0;
    if (light.web && !(greatest > 0)) return "the file of this light has no light";
    if (light.intensity && light.flux) return "`intensity` and `flux` exclude each other: give one";
    if (light.along_axis())
        return "`intensity` and `flux` need light that spreads, but the rays of this one are "
               "parallel";
    if (light.fade_distance != 0 || (light.fade_power != 0 && light.fade_power != 2))
        return "a light with an `intensity` or a `flux` falls with the square of the distance: it "
               "takes no `fade_distance` and no `fade_power`";
    if (light.colour == Rgb(0)) light.colour = Rgb(1);
    const double luminance = light_luminance(light.colour);
    if (!(luminance > 0)) return "the colour of a light with an `intensity` must not be negative";
    const double steradians = light.web || light.flux ? filled_steradians(light) : 1;
    if (!(steradians > 0)) return "the cone of this light is empty, so it cannot have a `flux`";
    const double most = light.flux ? *light.flux / steradians : light.intensity.value_or(greatest);
    light.colour *= most / luminance;
    light.fade_power = 2;
    light.fades_from_source = true;
    return {};
}

bool is_aimless(const PointLight& light) {
    return (light.beam == cone || light.along_axis()) && light.point_at == light.location;
}

std::string ignored(const PointLight& light) {
    if (light.fade_power > 0 && light.fade_distance == 0 && !light.fades_from_source)
        return "`fade_power` has no effect without a `fade_distance` before `#version 3.8`";
    if (!light.shadowless || light.beam == all_around) return {};
    return light.beam == cone
               ? "`spotlight` has no effect: a `shadowless` light shines all around"
               : "`cylinder` gives no edge to a `shadowless` light, which shines everywhere";
}

PointLight transformed(PointLight light, const Transform& transform) {
    light.location = transform.point(light.location);
    light.point_at = transform.point(light.point_at);
    light.area1 = transform.direction(light.area1);
    light.area2 = transform.direction(light.area2);
    if (!light.file().empty()) turn(light, transform);
    return light;
}

Vec3 axis_of(const PointLight& light) { return unit(light.point_at - light.location); }

void settle(PointLight& light) {
    light.shape = cone_shape(light);
    if (!light.web) return;
    light.aimed = make_handle<AimedWeb>(light);
    if (!light.intensity && !light.flux) light.colour *= tilt_factor(light);
}

Incidence incidence(const PointLight& light, const Vec3& from, const Vec3& point) {
    const Vec3 offset = from - point;
    const double distance = length(offset);
    if (distance == 0) return {Vec3(0, 1, 0), 0, Rgb(0)};
    Incidence result{offset / distance, distance, light.colour};
    if (light.kept_to() == cone && !light.along_axis()) {
        const LightConeShape shape = light.shape ? *light.shape : cone_shape(light);
        result.colour *= in_cone(light, shape, -dot(shape.axis, result.direction));
        if (result.colour == Rgb(0)) return result;
    }
    if (light.along_axis()) {
        if (light.kept_to() == parallel_beam) {
            const Vec3 beam = point - light.location, along = axis_of(light);
            const double ahead = dot(beam, along);
            result.colour *= ahead < 0 ? 0 : in_beam(light, length(beam - ahead * along));
        }
        // Each light of a grid has its own axis to the common `point_at`.
        result.direction = -unit(light.point_at - from);
        result.distance = dot(offset, result.direction);
    }
    if (light.web)
        result.colour *= light.aimed ? light.aimed->share(-offset) : AimedWeb(light).share(-offset);
    result.colour *= faded(light, std::abs(result.distance));
    return result;
}

bool is_beside_cone(const PointLight& light, const Vec3& point) {
    constexpr double rounding = 1e-9;
    if (!light.shape || light.kept_to() != cone || light.along_axis()) return false;
    const Vec3 offset = point - light.location;
    const double ahead = dot(light.shape->axis, offset);
    if (ahead <= 0) return true;
    const double least = std::fmin(light.shape->bright, light.shape->dark) - rounding;
    return least > 0 && ahead * ahead < least * least * dot(offset, offset);
}

Vec3 grid_point(const PointLight& light, double place1, double place2, const Vec3& direction) {
    const auto along = [](double place, int size) {
        return size > 1 ? place / (size - 1) - 0.5 : 0.0;
    };
    double a = along(place1, light.size1), b = along(place2, light.size2);
    if ((light.circular || light.orient) && light.size1 > 1 && light.size2 > 1) {
        a += 0.001;
        b += 0.001;
        const double scale = std::max(std::abs(a), std::abs(b)) / std::sqrt(a * a + b * b);
        a *= scale;
        b *= scale;
    }
    Vec3 side1 = light.area1, side2 = light.area2;
    if (light.orient) {
        const double size = length(light.area1);
        const Vec3 upright =
            std::abs(std::abs(direction.z) - 1) < 0.01 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
        side1 = unit(cross(direction, upright));
        side2 = size * unit(cross(direction, side1));
        side1 *= size;
    }
    return light.location + a * side1 + b * side2;
}

Vec3 drawn_grid_point(const PointLight& light, const Vec2& u, const Vec3& direction) {
    return grid_point(light, std::floor(u.x * light.size1), std::floor(u.y * light.size2),
                      direction);
}

}  // namespace candelabra
