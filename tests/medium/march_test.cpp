// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/march.h"

#include "support/media.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

namespace candelabra {

namespace {

struct Means {
    Rgb left, emitted, first, second;
};

/// Means over many marches; `first` and `second` are the integrals of scattering, and of scattering
/// times the distance.
Means marched(const Media& media, double distance, double near, std::uint32_t count,
              const MediaStretch::Worth* worth = nullptr) {
    const std::array<const Media*, 1> view = {&media};
    const Ray ray{Vec3(0.001, 0.01, 0.02), Vec3(1, 0, 0)};
    Means means;
    MediaMarch out;
    Key key;
    for (key.sample = 0; key.sample < count; ++key.sample) {
        march(view, {ray, distance, near, 8, worth}, {}, key, out);
        means.left += out.veil.transmittance / static_cast<double>(count);
        means.emitted += out.veil.added / static_cast<double>(count);
        for (const MediaPlace& place : out.places) {
            const Rgb light = place.weight * place.scattering / static_cast<double>(count);
            means.first += light;
            means.second += light * place.distance;
        }
    }
    return means;
}

}  // namespace

TEST_CASE("a march through a medium that is the same everywhere has the closed forms", "[medium]") {
    const Media media =
        media_of("absorption 0.5 emission <1, 2, 0> scattering { 1, 0.25 extinction 2 }");
    const Means found = marched(media, 3, 5, 2000);
    CHECK(found.left.r == Approx(std::exp(-3)));
    CHECK(found.emitted.r == Approx(1 - std::exp(-3)));
    CHECK(found.emitted.g == Approx(2 - 2 * std::exp(-3)));
    CHECK(found.first.r == Approx(0.25 * (1 - std::exp(-3))).epsilon(1e-3));
    CHECK(found.second.r == Approx(0.25 * (1 - 4 * std::exp(-3))).epsilon(1e-3));
}

TEST_CASE("a march through a density that grows is unbiased", "[medium]") {
    const Media media = media_of(
        "absorption 1 emission 2 scattering { 1, 0.5 extinction 0 } density { gradient x scale 3 "
        "}");
    // The density is x / 3: the optical depth is x^2 / 6.
    const Means found = marched(media, 3 - 0.002, 5, 20000);
    CHECK(found.left.r == Approx(std::exp(-1.5)).epsilon(0.01));
    CHECK(found.emitted.r == Approx(2 * (1 - std::exp(-1.5))).epsilon(0.01));
    CHECK(found.first.r == Approx(0.5 * (1 - std::exp(-1.5))).epsilon(0.01));
}

TEST_CASE("far parts of a ray are not forgotten", "[medium]") {
    for (const char* const words : {"scattering { 1, 1e-4 }",
                                    "scattering { 1, 1e-4 } density { bozo color_map { [0 rgb 1] "
                                    "[1 rgb 1] } }"}) {
        INFO(words);
        const Means found = marched(media_of(words), 2e10, 10, 20000);
        CHECK(found.first.r == Approx(1).epsilon(0.03));
        CHECK(found.left.r == Approx(0).margin(1e-6));
    }
}

TEST_CASE("where points are dense does not change what is expected", "[medium]") {
    const auto bright = [](std::span<const Vec3> places, std::span<double> worth) {
        for (std::size_t i = 0; i < places.size(); ++i)
            worth[i] = 1 / (0.01 + (places[i].x - 1) * (places[i].x - 1));
    };
    const MediaStretch::Worth worth(bright);
    for (const char* const density : {"", "density { gradient x scale 3 }"}) {
        const std::string words =
            std::string("absorption 0.7 scattering { 1, 0.5 extinction 1 } ") + density;
        const Means even = marched(media_of(words), 2.9, 5, 20000),
                    dense = marched(media_of(words), 2.9, 5, 20000, &worth);
        CHECK(dense.left.r == Approx(even.left.r).epsilon(0.01));
        CHECK(dense.first.r == Approx(even.first.r).epsilon(0.01));
        CHECK(dense.second.r == Approx(even.second.r).epsilon(0.01));
    }
}

TEST_CASE("what scatters nothing has no places", "[medium]") {
    const Media media = media_of("emission 1 density { gradient x }");
    const std::array<const Media*, 1> view = {&media};
    MediaMarch out;
    const Ray ray{Vec3(0), Vec3(1, 0, 0)};
    march(view, {ray, 4, 4, 8}, {}, {}, out);
    CHECK(out.places.empty());
    CHECK(out.veil.transmittance == Rgb(1));
    CHECK(out.veil.added.r > 0);
    march({}, {ray, 4, 4, 8}, {}, {}, out);
    CHECK(out.veil.added == Rgb(0));
}

}  // namespace candelabra
