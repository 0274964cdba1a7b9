// SPDX-License-Identifier: GPL-3.0-or-later
// What each light sampling strategy answers to a receiver: the interface that the renderer calls.
// It is run for each alternative, for surfaces and for places in the air, with and without the
// scattering there and rays through the scene.
#include "lighting/draw.h"
#include "scattering/scatterer.h"
#include "support/painted_sky.h"
#include "support/strategies.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <span>
#include <string>

namespace candelabra {

namespace {

using std::numbers::pi;

constexpr int lamps = 20;

Finish shiny(double diffuse, double back, double phong) {
    Finish result;
    result.diffuse = diffuse;
    result.diffuse_back = back;
    result.phong = phong;
    result.phong_size = 30;
    return result;
}

Finish rough_metal() {
    Finish result;
    result.diffuse = 0;
    result.microfacet.on = true;
    result.microfacet.roughness = 0.4;
    result.microfacet.metallic = 1;
    return result;
}

/// A place that scatters light, and what a query says of it.
struct LitPlace {
    std::string name;
    Receiver point;
    std::optional<Finish> finish = {};  ///< none: the scattering is not told

    std::optional<Bsdf> bsdf() const {
        if (!finish) return {};
        Shading shading;
        shading.position = point.position;
        shading.normal = shading.smooth_normal = shading.geometric_normal = point.normal;
        shading.view = unit(Vec3(0.3, 0.1, 0.2) - 1.2 * point.normal);
        shading.finish = &*finish;
        shading.colour = {Rgb(0.7)};
        shading.both_sides = point.horizon == Horizon::both_sides;
        return Bsdf(shading, rules);
    }

    static inline const ShadingRules rules;
};

std::vector<LitPlace> places_in(const Room& room) {
    const Vec3 up = unit(Vec3(0.2, 1, -0.1)), first = room.surfaces[0].low,
               second = room.surfaces[3].low;
    return {{"matte", {first, up, Horizon::one_side}, shiny(0.7, 0, 0)},
            {"shiny", {first, up, Horizon::one_side}, shiny(0.3, 0, 0.6)},
            {"shiny only", {second, -up, Horizon::one_side}, shiny(0, 0, 0.8)},
            {"metal", {second, up, Horizon::one_side}, rough_metal()},
            {"lit from behind, too", {second, up, Horizon::both_sides}, shiny(0.4, 0.4, 0)},
            {"not told", {first, -up, Horizon::one_side}},
            {"in the air", {Vec3(0.5, 0.4, -0.3), Vec3(0), Horizon::none}}};
}

/// Nearest luminaire or wall on a ray.
std::optional<ProbeHit> look_into(const Room& room, const Ray& ray, double tolerance) {
    std::optional<ProbeHit> nearest;
    LightHits met;
    for (LightIndex light = 0; light < room.luminaires.size(); ++light) {
        met.clear();
        const Luminaire& luminaire = room.luminaires[light];
        intersect(luminaire, {ray.origin, Vec3(0), Horizon::none}, ray.direction, met);
        for (const LightHit& hit : met)
            if (hit.distance > tolerance && (!nearest || hit.distance < nearest->distance))
                nearest = {hit.distance, -ray.direction, 1e-9, light,
                           luminance(luminaire.radiance)};
    }
    return nearest;
}

/// Whether queries come with rays through the scene. A cell that was made without them has no
/// survey.
enum class Rays { with_and_without, with };

/// Calls use(answer, receiver) for each place, with what is told to the strategy.
template <class Built, class Use>
void for_answers(const Room& room, const Built& built, const Use& use,
                 Rays rays = Rays::with_and_without) {
    const auto look = [&](const Ray& ray, double tolerance) {
        return look_into(room, ray, tolerance);
    };
    const LightProbe probe(look);
    for (const LitPlace& place : places_in(room))
        for (const LightProbe* scene : {static_cast<const LightProbe*>(nullptr), &probe}) {
            if (!scene && rays == Rays::with) continue;
            INFO(place.name << (scene ? " with rays" : ""));
            const std::optional<Bsdf> bsdf = place.bsdf();
            const BsdfLobes lobes = bsdf ? bsdf->lobes() : BsdfLobes{};
            const auto draw = [&](Vec2 u) { return bsdf->sample(u); };
            const auto pdf = [&](const Vec3& direction) { return bsdf->pdf(direction); };
            const BsdfSampler sampler{bsdf ? bsdf->specular_probability() : 0, draw, pdf};
            const BsdfSampler* told = bsdf ? &sampler : nullptr;
            use(built.at({place.point, lobes, told, scene, true}), place.point);
        }
}

constexpr int rows = 16, columns = 32;

std::size_t bin_of(const Vec3& d) {
    const int row = std::min(static_cast<int>((d.y + 1) / 2 * rows), rows - 1);
    const int column = static_cast<int>((std::atan2(d.z, d.x) / pi + 1) / 2 * columns) % columns;
    return static_cast<std::size_t>(row * columns + column);
}

/// The density of sampled directions, integrated over each bin.
template <class Answer>
std::vector<double> said_by(const Answer& answer) {
    std::vector<double> said(rows * columns, 0);
    constexpr int fine_rows = 20 * rows, fine_columns = 16 * columns;
    for (int i = 0; i < fine_rows; ++i)
        for (int j = 0; j < fine_columns; ++j) {
            const double y = 2 * (i + 0.5) / fine_rows - 1,
                         turn = 2 * pi * (j + 0.5) / fine_columns - pi,
                         across = std::sqrt(1 - y * y);
            const Vec3 d(across * std::cos(turn), y, across * std::sin(turn));
            said[bin_of(d)] += answer.pdf(d, 0, 0) * 4 * pi / (fine_rows * fine_columns);
        }
    return said;
}

/// Calls use(light, direction, weight) with the weight 1 / pdf of each point of a luminaire that a
/// sample counts, as the renderer does.
template <class Answer, class Use>
void count_sample(const Answer& answer, const Room& room, const Receiver& point, const Key& key,
                  const Use& use) {
    LightSamples samples;
    answer.sample(key, samples);
    LightHits met;
    if (samples.direction)
        for (LightIndex light = 0; light < room.luminaires.size(); ++light) {
            met.clear();
            intersect(room.luminaires[light], point, *samples.direction, met);
            for (const LightHit& hit : met)
                use(light, *samples.direction,
                    1 / answer.pdf(*samples.direction, answer.expected(key, light), hit.density));
        }
    const bool several = samples.picks.size() > 1;
    for (const LightPick& pick : samples.picks) {
        const Key own = several ? key.with_branch(pick.light) : key;
        const auto there = sample(room.luminaires[pick.light], point, place_on_light(own));
        if (there)
            use(pick.light, there->direction,
                1 / answer.pdf(there->direction, pick.expected, there->density));
    }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("directions come as often as their density says", "[lighting]",
                        Strategies) {
    const Room room(lamps, 11);
    const auto built = built_with(settings<TestType>(), room.scene(), 1);
    std::uint64_t pixel = 0;
    for_answers(room, built, [&](const auto& answer, const Receiver&) {
        const std::vector<double> said = said_by(answer);
        std::vector<double> drawn(said.size(), 0);
        constexpr int count = 20000;
        ++pixel;
        LightSamples samples;
        for (int i = 0; i < count; ++i) {
            samples.clear();
            answer.sample(key_of(pixel, i), samples);
            if (samples.direction) drawn[bin_of(*samples.direction)] += 1.0 / count;
        }
        double squares = 0, all = 0, kept = 0;
        for (std::size_t b = 0; b < said.size(); ++b) {
            const double apart = drawn[b] - said[b];
            squares += apart * apart / (said[b] / count + 1e-6);
            all += said[b], kept += drawn[b];
        }
        const double bins = static_cast<double>(said.size());
        CHECK(squares < bins + 5 * std::sqrt(2 * bins));
        CHECK(kept == Approx(all).margin(0.004 + 5 * std::sqrt(0.25 / count)));
    });
}

TEMPLATE_LIST_TEST_CASE("the points that samples find, weighted by 1 / pdf, are all light",
                        "[lighting]", Strategies) {
    const Room room(lamps, 12);
    const auto built = built_with(settings<TestType>(), room.scene(), 1);
    std::uint64_t pixel = 50;
    for_answers(room, built, [&](const auto& answer, const Receiver& point) {
        constexpr int trials = 4000;
        std::array<double, lamps> sum{}, square{};
        ++pixel;
        for (int trial = 0; trial < trials; ++trial) {
            std::array<double, lamps> here{};
            count_sample(answer, room, point, key_of(pixel, trial),
                         [&](LightIndex light, const Vec3& direction, double weight) {
                             const double cosine = std::fmax(point.cosine(direction), 0);
                             here[light] +=
                                 cosine * weight * luminance(room.luminaires[light].radiance);
                         });
            for (int light = 0; light < lamps; ++light) {
                sum[light] += here[light] / trials;
                square[light] += here[light] * here[light] / trials;
            }
        }
        std::array<double, lamps> all_given{};
        for (int light = 0; light < lamps; ++light)
            all_given[light] = sampled_irradiance(room.luminaires[light], point, 60);
        const double all = std::accumulate(all_given.begin(), all_given.end(), 0.0);
        for (int light = 0; light < lamps; ++light) {
            const double given = all_given[light];
            // Of a luminaire that hardly rises above the horizon the grid has too few points.
            if (given < 1e-9 * all) continue;
            const double variance = std::fmax(square[light] - sum[light] * sum[light], 0) / trials;
            // A luminaire that was found a few times only has no mean to be compared.
            if (variance > 0.04 * sum[light] * sum[light] || sum[light] == 0) continue;
            INFO("luminaire " << light << ": " << sum[light] << " of " << given);
            CHECK(std::abs(sum[light] - given) <= 5 * std::sqrt(variance) + 0.01 * given);
        }
    });
}

TEMPLATE_LIST_TEST_CASE("what gives light has a density above 0 with every question", "[lighting]",
                        Strategies) {
    const Room room(lamps, 13);
    const auto built = built_with(settings<TestType>(), room.scene(), 1);
    Draw draw(5);
    int lit_anywhere = 0;
    for_answers(room, built, [&](const auto& answer, const Receiver& point) {
        int lit = 0, impossible = 0;
        for (int i = 0; i < 3000; ++i) {
            const auto light = static_cast<LightIndex>(i % lamps);
            const auto there =
                sample(room.luminaires[light], point, {draw.number(), draw.number()});
            if (!there || !(point.cosine(there->direction) > 1e-12)) continue;
            ++lit;
            const double density =
                answer.pdf(there->direction, answer.expected(key_of(7, i), light), there->density);
            impossible += !(density > 0 && std::isfinite(density));
        }
        lit_anywhere += lit;
        CHECK(impossible == 0);
    });
    CHECK(lit_anywhere > 10000);
}

TEMPLATE_LIST_TEST_CASE("luminaires that no direction hits are picked as often as it is said",
                        "[lighting]", Strategies) {
    const Room room(lamps, 14);
    const auto built = built_with(settings<TestType>(), room.scene(), 1);
    std::uint64_t pixel = 90;
    for_answers(room, built, [&](const auto& answer, const Receiver&) {
        constexpr int trials = 4000;
        std::array<double, lamps> evened{}, square{};
        ++pixel;
        LightSamples samples;
        for (int trial = 0; trial < trials; ++trial) {
            samples.clear();
            answer.sample(key_of(pixel, trial), samples);
            for (const LightPick& pick : samples.picks) {
                const double weight = 1 / pick.expected;
                evened[pick.light] += weight / trials;
                square[pick.light] += weight * weight / trials;
            }
        }
        for (int light = 0; light < lamps; ++light) {
            const double mean = evened[light], sigma = std::sqrt(square[light] / trials);
            if (mean == 0 || sigma > 0.2 * mean) continue;  // hardly ever picked
            INFO("luminaire " << light);
            CHECK(std::abs(mean - 1) <= 5 * sigma);
        }
    });
}

TEST_CASE("the sky and luminaires that one draw finds, weighted by 1 / pdf, are all light",
          "[lighting]") {
    const Room room(lamps, 15);
    const PaintedSky sky;
    LightScene scene = room.scene();
    for (const bool with_lamps : {true, false}) {
        const std::span<const Luminaire> chosen =
            with_lamps ? std::span<const Luminaire>(room.luminaires) : std::span<const Luminaire>();
        scene.lights = choices_under_sky(chosen);
        const BuiltCutOctree built(settings<LightOctree>(), scene);
        std::uint64_t pixel = 120;
        for_answers(
            room, built,
            [&](const auto& answer, const Receiver& point) {
                REQUIRE(answer.takes_sky());
                constexpr int trials = 6000;
                double sum = 0, square = 0;
                ++pixel;
                for (int trial = 0; trial < trials; ++trial) {
                    const Key key = key_of(pixel, trial);
                    LightSamples samples;
                    answer.sample(key, samples);
                    double here = 0;
                    const auto add = [&](const Vec3& direction, double expected) {
                        const double cosine = std::fmax(point.cosine(direction), 0);
                        here += cosine * sky.luminance(direction) /
                                answer.pdf(direction, expected, sky.density(direction));
                    };
                    if (samples.direction) add(*samples.direction, answer.expected(key, sky_light));
                    for (const LightPick& pick : samples.picks)
                        if (pick.light == sky_light)
                            add(sky.draw(place_on_light(key)), pick.expected);
                    sum += here / trials;
                    square += here * here / trials;
                }
                // Of luminance 2 + y.
                const bool in_air = point.horizon == Horizon::none;
                const double given = in_air ? 8 * pi
                                     : point.horizon == Horizon::both_sides
                                         ? 4 * pi
                                         : 2 * pi + 2.0 / 3 * pi * point.normal.y;
                const double sigma = std::sqrt(std::fmax(square - sum * sum, 0) / trials);
                CAPTURE(with_lamps, sum, given, sigma);
                CHECK(std::abs(sum - given) <= 5 * sigma);
                CHECK(sigma < 0.1 * given);
            },
            Rays::with);
    }
}

}  // namespace candelabra
