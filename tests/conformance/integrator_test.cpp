// SPDX-License-Identifier: GPL-3.0-or-later
// Each integrator keeps the promises of the concept IntegratorKind.
#include "transport/integrator.h"

#include "render/render.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <string>

namespace candelabra {

namespace {

template <class Integrator>
const char* settings_of();
template <>
const char* settings_of<PovRayIntegrator>() {
    return "global_settings { integrator { pov_ray } }";
}
template <>
const char* settings_of<PathTracedIntegrator>() {
    return "global_settings { integrator { path_traced bounces 0 } }";
}

/// Lamps of all kinds, and surfaces and media that show them in all ways.
template <class Integrator>
Shot everything() {
    return shot_of(std::string("#version 3.7; global_settings { max_trace_level 6 } ") +
                   settings_of<Integrator>() + R"(
        #default { finish { ambient 0 } }
        camera { location <0, 1, -6> look_at <0, 0.5, 0> }
        sky_sphere { pigment { gradient y color_map { [0 rgb 0] [1 rgb <0.2, 0.3, 0.4>] } } luminaire }
        light_source { <-4, 6, -4>, rgb <1, 0.8, 0.5> }
        sphere { <0, 2, 0.5>, 0.3 pigment { rgb 1 } finish { diffuse 0 emission <2, 3, 1> } }
        plane { y, -1 pigment { checker rgb 0.9, rgb <0.6, 0.3, 0.2> } finish { reflection 0.3 } }
        sphere { <-1.5, 0, 0>, 1 pigment { rgbf <0.9, 1, 0.9, 0.8> }
            finish { specular 0.5 reflection { 0.1, 0.4 fresnel } conserve_energy } interior { ior 1.4 } }
        sphere { <1.5, 0, 0>, 1 pigment { rgb 0.7 } finish { microfacet { roughness 0.4 metallic 1 } } }
        sphere { <0, 0, 2>, 1.5 hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.3 } } } })");
}

Key key_of(std::uint32_t pixel, std::uint32_t sample) {
    Key key;
    key.pixel = pixel;
    key.sample = sample;
    return key;
}

Ray ray_of(std::uint32_t pixel) {
    return {Vec3(0, 1, -6), unit(Vec3(0.05 * (pixel % 16) - 0.4, 0.03 * (pixel / 16) - 0.3, 1))};
}

constexpr std::uint32_t pixels = 256;

}  // namespace

TEMPLATE_TEST_CASE("an integrator is a pure function of ray and key", "[transport]",
                   PovRayIntegrator, PathTracedIntegrator) {
    const Shot shot = everything<TestType>();
    Tracing tracing;
    tracing.sent = SentLight::of(shot, 0, 1);
    TestType forwards(shot, tracing), backwards(shot, tracing);
    std::vector<Rgb> seen(pixels);
    for (std::uint32_t i = 0; i < pixels; ++i) seen[i] = forwards.radiance(ray_of(i), key_of(i, 3));
    int lit = 0;
    for (std::uint32_t i = pixels; i-- > 0;) {
        CHECK(backwards.radiance(ray_of(i), key_of(i, 3)) == seen[i]);
        lit += seen[i] != Rgb(0);
    }
    CHECK(lit > 200);
}

TEMPLATE_TEST_CASE("an integrator's ledger has each camera ray, and all light by its lamp",
                   "[transport]", PovRayIntegrator, PathTracedIntegrator) {
    const Shot shot = everything<TestType>();
    Tracing tracing;
    tracing.sent = SentLight::of(shot, 0, 1);
    tracing.counts_lights = true;
    TestType integrator(shot, tracing);
    for (std::uint32_t i = 0; i < pixels; ++i) {
        const Rgb seen = integrator.radiance(ray_of(i), key_of(i, 1));
        Rgb sum(0);
        take_lights(integrator.ledger(), [&](std::size_t, const Rgb& light) { sum += light; });
        for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(seen[c]).margin(1e-9));
        CHECK(integrator.clear() >= 0);
        CHECK(integrator.clear() <= 1);
        CHECK_FALSE(integrator.cut());
    }
    const LightLedger& ledger = integrator.ledger();
    CHECK(ledger.camera == pixels);
    std::uint64_t rays = 0;
    for (const LightCount& each : ledger.lights) rays += each.rays;
    CHECK(rays == ledger.shadow);
}

TEMPLATE_TEST_CASE("a ray without a direction sees nothing", "[transport]", PovRayIntegrator,
                   PathTracedIntegrator) {
    const Shot shot = everything<TestType>();
    Tracing tracing;
    tracing.sent = SentLight::of(shot, 0, 1);
    TestType integrator(shot, tracing);
    CHECK(integrator.radiance({Vec3(0), Vec3(0)}, Key()) == Rgb(0));
}

TEST_CASE("integrators agree without bounces", "[transport]") {
    const Shot one = everything<PovRayIntegrator>(), other = everything<PathTracedIntegrator>();
    PovRayIntegrator pov(one, {.sent = SentLight::of(one, 0, 1)});
    PathTracedIntegrator path(other, {.sent = SentLight::of(other, 0, 1)});
    // The mean of the difference over blocks of pixels, beside its own standard deviation. The
    // glass is left out: only path_traced keeps its energy.
    for (std::uint32_t block = 0; block < 8; ++block) {
        double sum = 0, squares = 0;
        int count = 0;
        for (std::uint32_t i = 0; i < 32; ++i) {
            const std::uint32_t pixel = 32 * block + i;
            if (pixel % 16 < 8) continue;
            for (std::uint32_t sample = 0; sample < 400; ++sample, ++count) {
                const double apart =
                    grey(pov.radiance(ray_of(pixel), key_of(pixel, sample)) -
                         path.radiance(ray_of(pixel), key_of(pixel, sample + 1000)));
                sum += apart;
                squares += apart * apart;
            }
        }
        const double mean = sum / count, deviation = std::sqrt(squares) / count;
        CAPTURE(block, mean, deviation);
        CHECK(std::abs(mean) < 5 * deviation + 1e-12);
    }
}

}  // namespace candelabra
