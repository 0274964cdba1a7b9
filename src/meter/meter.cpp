// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/meter.h"

#include "vocabulary/schema.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candelabra {

namespace {

struct QuantityName {
    std::string_view name, unit;
};

/// In the order of Quantity.
constexpr auto quantity_names = std::to_array<QuantityName>({{"illuminance", "lx"},
                                                             {"cylindrical", "lx"},
                                                             {"semi_cylindrical", "lx"},
                                                             {"hemispherical", "lx"},
                                                             {"spherical", "lx"},
                                                             {"luminance", "cd/m2"},
                                                             {"ugr", ""},
                                                             {"threshold_increment", "%"},
                                                             {"daylight_factor", "%"}});

constexpr const QuantityName& names_of(Quantity quantity) {
    return quantity_names[static_cast<std::size_t>(quantity)];
}

constexpr int most_along = 10000;

/// A sentence about a word that the quantity does not have; empty if there is none.
std::string problem_with_words(const Meter& meter) {
    const Quantity quantity = meter.measures();
    const auto belongs = [](std::string_view word, Quantity to) {
        return "`" + std::string(word) + "` of `meter` is for `" + std::string(name_of(to)) + "`";
    };
    const bool sees = quantity == Quantity::luminance;
    if (meter.eye && !sees) return belongs("eye", Quantity::luminance);
    if (meter.cone > 0 && !sees) return belongs("cone", Quantity::luminance);
    if (!meter.road_table.empty() && !sees) return belongs("road_table", Quantity::luminance);
    if (!meter.road.empty() && quantity != Quantity::threshold_increment)
        return belongs("road", Quantity::threshold_increment);
    if (meter.cone > 0 && !meter.road_table.empty())
        return "`meter` has a `cone` and a `road_table`, which is for single points";
    const bool in_eye =
        meter.eye && std::ranges::find(meter.points, *meter.eye) != meter.points.end();
    return in_eye ? "a point of `meter` is in its `eye`, which cannot look at it" : "";
}

/// Whether the normal of the grid says neither up nor down.
bool stands_upright(const Meter& meter) {
    const Vec3 normal = cross(meter.along, meter.across);
    return std::abs(dot(normal, meter.up)) <= 1e-9 * length(normal) * length(meter.up);
}

}  // namespace

std::string_view unit_of(Quantity quantity) { return names_of(quantity).unit; }

std::string_view name_of(Quantity quantity) { return names_of(quantity).name; }

const ItemInfo Meter::vocabulary = described<Meter>([] {
    using F = Field<Meter>;
    constexpr auto measures = [](Quantity quantity, std::string_view help) {
        return chooses<Meter>(names_of(quantity).name, &Meter::quantity, static_cast<int>(quantity),
                              help);
    };
    constexpr auto spaced = [](std::string_view name, GridRule rule, std::string_view help) {
        return chooses<Meter>(name, &Meter::rule, static_cast<int>(rule), help);
    };
    return schema<Meter>(
        "meter",
        {"What is measured by --measure, and where. It changes no picture.",
         "meter { \"desk\" corner <-1, 0.8, -1> along 2*x across 2*z counts <4, 4> }",
         "meter { \"road\" luminance eye <-60, 1.5, 1.75> corner 0 along 35*x across 7*z en_13201 "
         "lanes 2 }",
         "meter { \"road\" luminance eye <-60, 1.5, 1.75> corner 0 along 35*x across 7*z en_13201 "
         "} meter { \"driver\" threshold_increment road \"road\" points { 1, <-18, 1.5, 1.75> } "
         "direction <1, -0.0175, 0> }",
         "meter { \"faces\" semi_cylindrical points { 2, <2, 1.5, 0>, <4, 1.5, 0> } direction -x "
         "up y }",
         "meter { \"room\" cylindrical corner <-1, 1.2, -1> along 2*x across 2*z en_12464 }",
         "meter { \"glare\" ugr points { 1, <0, 1.2, -2> } direction z }",
         "meter { \"ball\" spherical points { 1, y } }",
         "meter { \"sky\" hemispherical points { 1, y } maintenance 0.8 }",
         "meter { \"window\" daylight_factor corner <-1, 0.8, -1> along 2*x across 2*z }",
         "meter { \"desk\" illuminance points { 1, 0.8*y } }",
         "meter { \"spot\" luminance cone 1 points { 1, 2*y } direction -y }"},
        maybe(F{"name", &Meter::name, positional, "the name in results"}),
        measures(Quantity::illuminance, "lux on a plane that faces `direction`; the default"),
        measures(Quantity::cylindrical, "lux, the mean on the sides of a small upright cylinder"),
        measures(Quantity::semi_cylindrical,
                 "lux, the mean on the half of a small upright cylinder that faces `direction`"),
        measures(Quantity::hemispherical, "lux, the mean on the upper half of a small ball"),
        measures(Quantity::spherical, "lux, the mean on a small ball"),
        measures(Quantity::luminance,
                 "candela per square metre, as seen from `eye`, or in `direction`"),
        measures(Quantity::ugr,
                 "glare of luminaires by the unified rating of CIE 117, for an observer who looks "
                 "in `direction`"),
        measures(Quantity::threshold_increment,
                 "glare of lamps for a driver who looks in `direction`, by EN 13201, in per cent"),
        measures(Quantity::daylight_factor,
                 "illuminance in per cent of that under the free sky, without sun"),
        F{"corner", &Meter::corner, item, "where a grid or a line of points begins"},
        F{"along", &Meter::along, item, "from there along the first side"},
        F{"across", &Meter::across, item, "along the second side; without it the grid is a line"},
        F{"counts", &Meter::counts, item,
          "points along and across, in the middles of equal cells; without it by a rule",
          between(1, most_along)},
        spaced("en_12464", GridRule::en_12464,
               "as many points as EN 12464-1 wants of a room or a task; the default"),
        spaced("en_13201", GridRule::en_13201,
               "as many points as EN 13201-3 wants of a road between two lamps"),
        F{"lanes", &Meter::lanes, item, "of the road, for the points of en_13201", between(1, 100)},
        F{"points", &Meter::points, list, "single points in the place of a grid"},
        F{"direction", &Meter::direction, item,
          "where the plane faces, or the observer looks; without it the grid faces up"},
        F{"eye", &Meter::eye, item, "of an observer who looks at each point"},
        F{"up", &Meter::up, item, "axis of cylinders, and the vertical of observers"},
        F{"cone", &Meter::cone, item,
          "degrees around the line of sight over which luminance is averaged", between(0, 90)},
        F{"maintenance", &Meter::maintenance, item, "factor on all results", above(0)},
        F{"road", &Meter::road, item,
          "name of the meter of luminance whose mean threshold_increment compares with"},
        F{"road_table", &Meter::road_table, item,
          "CSV file with the reflection of the road, 10000 r by tan gamma and beta: luminance is "
          "that of the direct light of lamps by it, as in EN 13201"});
});

std::string problem(const Meter& meter) {
    const Quantity quantity = meter.measures();
    const bool any_side = meter.has_grid() || meter.across != Vec3(0) || meter.counts;
    if (any_side && !meter.points.empty())
        return "`meter` has `points` and a grid: two meters are needed";
    if (meter.points.empty() && !meter.has_grid())
        return "`meter` needs `points`, or a grid by `corner`, `along` and `across`";
    if (meter.counts && meter.rule != static_cast<int>(GridRule::none))
        return "`meter` has `counts` and a rule for them: one of both is needed";
    if (std::string wrong = problem_with_words(meter); !wrong.empty()) return wrong;
    if (meter.up == Vec3(0)) return "`up` of `meter` must not be zero";
    if (meter.direction && *meter.direction == Vec3(0))
        return "`direction` of `meter` must not be zero";
    const bool faces = quantity == Quantity::illuminance || quantity == Quantity::daylight_factor;
    if (meter.across != Vec3(0) && cross(meter.along, meter.across) == Vec3(0))
        return "`along` and `across` of `meter` have the same direction";
    if (faces && !meter.direction && meter.across != Vec3(0) && stands_upright(meter))
        return "`meter` stands upright: `direction` decides its side";
    const bool looks = quantity == Quantity::ugr || quantity == Quantity::threshold_increment ||
                       quantity == Quantity::semi_cylindrical;
    if (looks && !meter.direction)
        return "`" + std::string(name_of(quantity)) + "` of `meter` needs `direction`";
    if (quantity == Quantity::luminance && !meter.direction && !meter.eye)
        return "`luminance` of `meter` needs `eye` or `direction`";
    if (quantity == Quantity::threshold_increment && meter.road.empty())
        return "`threshold_increment` of `meter` needs `road`, the name of a meter of luminance";
    if (looks && cross(*meter.direction, meter.up) == Vec3(0))
        return "`direction` of `meter` leads straight up or down";
    return {};
}

}  // namespace candelabra
