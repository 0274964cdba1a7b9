// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/measurement.h"

#include "meter/places.h"
#include "output/estimates.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

using Json = nlohmann::json;

/// The name of a meter, or its number if it has none.
std::string label(const MeasuredScene& scene, std::size_t i) {
    const std::string& name = scene.meters[i].name;
    return name.empty() ? message("meter ", i + 1) : name;
}

/// Flux through the grid in lumens, if the meter has one and measures it.
std::optional<MeterValue> flux_of(const Meter& meter, const MeterReading& reading) {
    if (meter.measures() != Quantity::illuminance || reading.area == 0) return std::nullopt;
    const MeterValue& mean = reading.summary.mean;
    // No light gets through the parts of the grid that are inside of objects.
    const auto places = static_cast<double>(reading.values.size());
    const double open = reading.area * (1 - static_cast<double>(reading.left_out.size()) / places);
    return MeterValue{mean.value * open, mean.error * open};
}

Json place_json(const MeterReading& reading, std::size_t i) {
    const Vec3& at = reading.places[i].position;
    Json json = value_json(reading.values[i]);
    json["at"] = {at.x, at.y, at.z};
    return json;
}

std::string place_text(const Vec3& at) {
    return message("<", cell(at.x), ", ", cell(at.y), ", ", cell(at.z), ">");
}

}  // namespace

std::optional<ReadingFormat> reading_format(std::string_view file) {
    if (file == "-") return ReadingFormat::csv;
    const std::string_view ending = file.substr(std::min(file.size(), file.rfind('.')));
    if (same_letters(ending, ".csv")) return ReadingFormat::csv;
    if (same_letters(ending, ".json")) return ReadingFormat::json;
    return std::nullopt;
}

void review_meters(const World& world, std::span<const Meter> meters, Diagnostics& diagnostics) {
    if (meters.empty())
        diagnostics.add(
            error(Fault::missing, {}, "the scene has no meter to measure with")
                .with_help("meter { \"desk\" corner <0, 0.8, 0> along 4*x across 3*z }"));
    const double metres = world.rules.settings.light_units().metres;
    const auto any = [&](auto what) { return std::ranges::any_of(meters, what); };
    const auto is = [](Quantity quantity) {
        return [quantity](const Meter& meter) { return meter.measures() == quantity; };
    };
    for (const Meter& meter : meters) {
        if (places_of(meter, metres).empty())
            diagnostics.add(error(Fault::out_of_range, {},
                                  message("meter `", printable(meter.name), "` has more than ",
                                          most_meter_places, " points")));
        const bool found = any([&](const Meter& road) {
            return road.name == meter.road && road.measures() == Quantity::luminance;
        });
        if (meter.measures() == Quantity::threshold_increment && !found)
            diagnostics.add(
                error(Fault::unknown_name, {},
                      message("no meter of luminance is called `", printable(meter.road), "`")));
    }
    if (!world.facts.has_indirect_light)
        diagnostics.add(warning(Fault::no_effect, {},
                                "only direct light is measured: the integrator of the scene lets "
                                "surfaces light nothing")
                            .with_help("global_settings { integrator { path_traced } }"));
    if (any(is(Quantity::daylight_factor)) && world.sky.daylight &&
        world.sky.daylight->sunlight() != Rgb(0))
        diagnostics.add(warning(Fault::no_effect, {},
                                "daylight factors are for a sky without sun, but this one has it")
                            .with_help("sky_luminance { overcast ... }, or `direct 0`"));
    if (any(is(Quantity::daylight_factor)) &&
        (world.lights.any_glowing() || !world.lights.sources.empty()))
        diagnostics.add(warning(Fault::no_effect, {},
                                "the light of lamps counts in daylight factors as that of the sky "
                                "does")
                            .with_help("leave lamps out where daylight is measured: #if (Lamps)"));
    const bool dark = std::ranges::any_of(meters, [&](const Meter& meter) {
        return meter.measures() == Quantity::daylight_factor &&
               !(free_sky(world, unit(meter.up)) > 0);
    });
    if (dark)
        diagnostics.add(error(Fault::missing, {}, "a daylight factor needs a sky")
                            .with_help("sky_luminance { overcast }"));
    if (any(is(Quantity::ugr)) && !world.facts.has_indirect_light)
        diagnostics.add(error(Fault::missing, {},
                              "`ugr` compares lamps with the indirect light at the eye, and there "
                              "is none")
                            .with_help("global_settings { integrator { path_traced } }"));
    for (std::size_t i = 0; i < meters.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (!meters[i].name.empty() && meters[i].name == meters[k].name)
                diagnostics.add(
                    warning(Fault::no_effect, {},
                            message("two meters are called `", printable(meters[i].name), "`")));
    const bool one_by_one = any([&](const Meter& meter) {
        return is(Quantity::ugr)(meter) || is(Quantity::threshold_increment)(meter) ||
               !meter.road_table.empty();
    });
    if (one_by_one && !world.lights.media.empty())
        diagnostics.add(warning(Fault::no_effect, {},
                                "media that glow count neither in ratings of glare nor in the "
                                "luminance of roads by tables"));
    const bool endless = std::ranges::any_of(world.lights.sources, [](const PointLight& source) {
        return source.parallel && source.disc_edge == 1;
    });
    if (any(is(Quantity::ugr)) && endless)
        diagnostics.add(warning(Fault::no_effect, {},
                                "parallel light comes from no place, and so makes no glare by "
                                "`ugr`"));
}

void review_readings(const MeasuredScene& scene, const MeterGoal& goal, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < scene.meters.size(); ++i) {
        const Meter& meter = scene.meters[i];
        const MeterReading& reading = scene.readings[i];
        double error = 0;
        std::size_t dark = 0;
        for (const auto& [value, half] : reading.values) {
            if (value == 0 && half == 0)
                ++dark;
            else if (value != 0)
                error = std::max(error, half / std::abs(value));
        }
        const std::string name = message('`', printable(label(scene, i)), '`');
        if (!reading.reached && goal.counts(meter.measures()))
            diagnostics.add(
                warning(
                    Fault::option, {},
                    message(name, " is known within ", cell(rounded(100 * error, 2)), " %, and ",
                            cell(100 * goal.error), " % was asked for: it ended after ",
                            reading.samples, " samples of each point"))
                    .with_help("--until 10% asks for less; --time gives more time"));
        dark -= std::min(dark, reading.left_out.size());
        if (dark > 0 && unit_of(meter.measures()) == "lx")
            diagnostics.add(
                warning(Fault::no_effect, {},
                        message("no light reaches ", dark, dark == 1 ? " point" : " points", " of ",
                                name))
                    .with_help("a meter inside of a mesh, or in a surface, reads nothing"));
    }
}

void review_places(const MeasuredScene& scene, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < scene.meters.size(); ++i) {
        const MeterReading& reading = scene.readings[i];
        const std::size_t count = reading.left_out.size();
        if (count == 0) continue;
        diagnostics.add(
            warning(Fault::no_effect, {},
                    message(count, count == 1 ? " point" : " points", " of `",
                            printable(label(scene, i)), count == 1 ? "` is" : "` are",
                            " inside of objects, and left out: ",
                            place_text(reading.places[reading.left_out.front()].position)))
                .with_help("put the meter above what stands there, or leave these objects out "
                           "where light is measured"));
    }
}

std::string readings_as_csv(const MeasuredScene& scene) {
    std::string text = "meter,quantity,unit,point,x,y,z,value,low,high\n";
    for (std::size_t i = 0; i < scene.meters.size(); ++i) {
        const Quantity quantity = scene.meters[i].measures();
        const MeterReading& reading = scene.readings[i];
        const std::string begin =
            message(csv_cell(label(scene, i)), ',', name_of(quantity), ',', unit_of(quantity));
        for (std::size_t k = 0; k < reading.values.size(); ++k) {
            const Vec3& at = reading.places[k].position;
            const auto [value, error] = reading.values[k];
            if (std::ranges::binary_search(reading.left_out, k)) {
                text += message(begin, ',', k + 1, ',', at.x, ',', at.y, ',', at.z, ",,,\n");
                continue;
            }
            text += message(begin, ',', k + 1, ',', at.x, ',', at.y, ',', at.z, ',', cell(value),
                            ',', cell(value - error), ',', cell(value + error), '\n');
        }
    }
    return text;
}

std::string readings_as_json(const MeasuredScene& scene) {
    Json all{{"metres_per_unit", scene.units.metres},
             {"white_cd_m2", scene.units.white},
             {"seed", scene.seed},
             {"interval", "95 %: value - error to value + error"}};
    all["meters"] = Json::array();
    for (std::size_t i = 0; i < scene.meters.size(); ++i) {
        const Meter& meter = scene.meters[i];
        const MeterReading& reading = scene.readings[i];
        const MeterSummary& summary = reading.summary;
        Json json{{"name", label(scene, i)},
                  {"quantity", name_of(meter.measures())},
                  {"unit", unit_of(meter.measures())},
                  {"samples", reading.samples},
                  {"reached", reading.reached},
                  {"maintenance", meter.maintenance},
                  {"mean", value_json(summary.mean)},
                  {"min", place_json(reading, summary.least)},
                  {"max", place_json(reading, summary.greatest)},
                  {"uo", value_json(summary.uo)},
                  {"ud", value_json(summary.ud)}};
        if (!meter.road_table.empty()) json["road_table"] = meter.road_table;
        if (meter.has_grid()) {
            const GridCounts counts = counts_of(meter, scene.units.metres);
            json["counts"] = {counts.along, counts.across};
        }
        if (const auto flux = flux_of(meter, reading)) {
            json["flux_lm"] = value_json(*flux);
            json["area_m2"] = reading.area;
        }
        Json points = Json::array();
        for (std::size_t k = 0; k < reading.values.size(); ++k) {
            points.push_back(place_json(reading, k));
            if (std::ranges::binary_search(reading.left_out, k))
                points.back()["value"] = points.back()["error"] = nullptr;
        }
        json["points"] = std::move(points);
        all["meters"].push_back(std::move(json));
    }
    // Names may be in any encoding.
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string readings_as_text(const MeasuredScene& scene) {
    std::string text;
    for (std::size_t i = 0; i < scene.meters.size(); ++i) {
        const Meter& meter = scene.meters[i];
        const MeterReading& reading = scene.readings[i];
        const MeterSummary& summary = reading.summary;
        const std::string_view unit = unit_of(meter.measures());
        const std::size_t count = reading.values.size();
        text += message(printable(label(scene, i)), ": ", name_of(meter.measures()), " at ", count,
                        count == 1 ? " point" : " points", unit.empty() ? "" : ", ", unit,
                        meter.road_table.empty() ? "" : ", by the road of ",
                        printable(meter.road_table), '\n');
        if (count == 1) {
            text += message("  ", shown(reading.values[0]), '\n');
        } else {
            text += message("  mean ", shown(summary.mean), '\n');
            text += message("  min  ", shown(summary.min), " at ",
                            place_text(reading.places[summary.least].position), '\n');
            text += message("  max  ", shown(summary.max), " at ",
                            place_text(reading.places[summary.greatest].position), '\n');
            if (meter.measures() != Quantity::ugr)
                text += message("  Uo   ", shown(summary.uo), ", Ud ", shown(summary.ud), '\n');
        }
        if (const auto flux = flux_of(meter, reading))
            text += message("  flux ", shown(*flux), " lm through ", cell(reading.area), " m2\n");
    }
    return text;
}

}  // namespace candelabra
