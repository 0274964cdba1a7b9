// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"
#include "render/measure.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra::proof {

namespace {

/// Where meters stand, above the floor.
const Vec3 meter_place(0.9, 0.55, -1.1);

/// The column of a lamp: luminaires first, then sources and the sky.
LampColumns all_lamps(const World& world) {
    const std::size_t luminaires = world.lights.glowing(), sources = world.lights.sources.size();
    return {luminaires + sources + 1, [=](Lamp lamp) {
                if (lamp.is_sky()) return luminaires + sources;
                return lamp.is_source() ? luminaires + lamp.index() : std::size_t{lamp.index()};
            }};
}

/// Readings of a meter at the place, one for each pixel. By lamps: sums of what the lamps give.
Image readings(const Prepared& scene, Meter meter, bool by_lamps, int samples, int seed,
               const Deadline& end) {
    const RenderSettings settings = scene.settings(samples, seed);
    Image image(settings.width, settings.height);
    meter.points.assign(image.pixels.size(), meter_place);
    MeasureSettings wanted;
    wanted.seed = seed;
    wanted.threads = 1;
    wanted.samples = samples;
    wanted.ended = [&] { return end.over(); };
    if (by_lamps) wanted.lamps = all_lamps(*scene.shot().world);
    const MeterReading found = measure(scene.shot(), {&meter, 1}, wanted).front();
    if (end.over()) return {};
    const std::size_t count = wanted.lamps.count;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        double value = by_lamps ? 0 : found.values[i].value;
        for (std::size_t k = 0; k < count; ++k)
            for (const MeterHalf& half : found.halves) value += half.by_column[i * count + k] / 2;
        image.pixels[i] = Rgb(value);
    }
    return image;
}

/// The reading of a meter instead of the picture of the script.
std::vector<Term> read(const Script& script, const Meter& meter, bool by_lamps = false,
                       double factor = 1, const Writing& writing = {}) {
    std::vector<Term> terms = picture(script, writing, factor);
    terms.front().view = [=](const Prepared& scene, int samples, int seed, const Deadline& end) {
        return readings(scene, meter, by_lamps, samples, seed, end);
    };
    return terms;
}

Meter of_quantity(Quantity quantity) {
    Meter meter;
    meter.quantity = static_cast<int>(quantity);
    meter.direction = Vec3(0, 1, 0);
    return meter;
}

/// A road that is as bright from everywhere: one over pi of its illuminance.
Handle<RoadTable> diffuse_road() {
    RoadTable road{{}, {0}, {}};
    for (double tangent = 0; tangent < 200; tangent = 1.02 * tangent + 0.02) {
        const double cosine = 1 / std::sqrt(1 + tangent * tangent);
        road.tangents.push_back(tangent);
        road.entries.push_back(1e4 / std::numbers::pi * cosine * cosine * cosine);
    }
    return make_handle<RoadTable>(std::move(road));
}

/// Whether an object glows without bounds: it is no lamp then, and paths find its light.
bool glows_endlessly(const Element& element) {
    return is_object(element) && (mentions(element, "inverse") || mentions(element, "plane {")) &&
           mentions(element, "emission");
}

/// The script without what glows around and behind its lamps, and with a meter, so that no lamp is
/// left out.
Script with_meter(Script script) {
    std::erase_if(script.elements, [](const Element& each) {
        return each.head == "background" || each.head == "sky_sphere" || each.head == "media" ||
               glows_endlessly(each);
    });
    script.elements.push_back(block("meter", "points { 1, 0 } direction y"));
    return script;
}

}  // namespace

/// A lamp whose file says how it dims as it is turned, beside the lamps of the draft.
Script on_road(Draft& draft) {
    // The object neither glows nor shows or reflects lamps, which a table of a road does not know.
    draft.finish = block("finish", "diffuse 0");
    draft.structure = {};
    draft.modifiers = {};
    Script script = with_meter(staged(draft));
    std::erase(script.elements, ball_beside());  // it reflects light onto the road
    // A table is for lamps, and a sky is none.
    std::erase_if(script.elements,
                  [](const Element& each) { return each.head == "sky_luminance"; });
    if (draft.dice.chance(0.5)) {
        const std::string file = "ies \"tilt-include-1986.ies\" aim <0.4, -1, 0.2> ";
        script.elements.push_back(
            draft.dice.chance(0.5)
                ? block("light_source", "<1.5, 3, -2>, rgb 1 " + file)
                : block("sphere",
                        "<1.5, 3, -2>, 0.1 pigment { rgb 1 } finish { diffuse 0 } "
                        "luminaire { " +
                            file + "}"));
    }
    return script;
}

Claims meters_by_parts(const Script& drawn, Dice& dice) {
    const Script script = with_meter(drawn);
    Meter meter = of_quantity(dice.pick<Quantity>(
        {Quantity::illuminance, Quantity::cylindrical, Quantity::spherical, Quantity::luminance}));
    if (meter.measures() == Quantity::luminance) meter.direction = Vec3(0.2, -1, 0.3);
    std::vector<Term> parts = read(script, meter, true);
    for (Term& rest : read(script, meter, false, 1, {.only = script.lights}))
        parts.push_back(std::move(rest));
    return {same_mean("lamps of a meter = the meter", read(script, meter), std::move(parts))};
}

Claims roads_by_tables(const Script& drawn, Dice& dice) {
    Script script = drawn;
    for (Element& each : script.elements) each = with_closed_sets(std::move(each));
    // A road is as bright as its lamps are seen, with what these reflect themselves.
    const Script direct = with_setting(script, "integrator", "path_traced bounces 0"),
                 once = with_setting(script, "integrator",
                                     "path_traced reflected_luminaires 0 bounces 1");
    Meter road = of_quantity(Quantity::luminance);
    road.eye = Vec3(-2, 1.2, dice.pick<double>({-3, 0.4}));
    road.surface = diffuse_road();
    const Meter floor = of_quantity(Quantity::illuminance);
    return {same_mean("diffuse road by a table = diffuse floor", read(direct, road),
                      read(once, floor, false, 1 / std::numbers::pi), 1e-2),
            same_mean("lamps of a road = the road", read(direct, road, true), read(direct, road))};
}

}  // namespace candelabra::proof
