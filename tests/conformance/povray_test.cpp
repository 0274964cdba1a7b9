// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels that POV-Ray 3.7 computes (scene text and values), for the part of its vocabulary that this
// version has: povray.json and public_scenes.json as it prints them, radiosity.json, media.json and photons.json as its
// radiosity, its media and its photons have them when they converge. (POV-Ray overlooks surfaces
// within fixed distances of a ray's start; we do not, so scenes that show that are not among them.)
#include "render/render.h"

#include "support/scripts.h"
#include "surface/quality.h"
#include "world/compile.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

namespace candelabra {

namespace {

/// Renders the scene of a case without antialiasing, with so many samples (0: as many as it needs),
/// and compares its pixels.
void check_pixels(const nlohmann::json& c, int samples) {
    const std::string name = c["name"];
    INFO(name);
    Diagnostics diagnostics;
    CompileOptions options;
    options.quality = c.value("quality", quality_full);
    const Shot shot(compile(scene_of(c["scene"]), options, diagnostics));
    RenderSettings settings;
    settings.width = c["width"];
    settings.height = c["height"];
    settings.antialias = false;
    settings.samples = samples;
    const Image image = render(shot, settings).image;
    // Files of 16 bits round to this; they clip to 0..1 as well.
    const double tolerance = std::max(c["tolerance"].get<double>(), 3e-5);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const double expected =
                    c["pixels"][static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]
                     [static_cast<std::size_t>(channel)];
                const double found = glm::clamp(image.at(x, y)[channel], 0.0, 1.0);
                INFO("pixel " << x << ' ' << y << " channel " << channel);
                CHECK(found == Approx(expected).margin(tolerance));
            }
}

nlohmann::json cases_of(const std::string& file) {
    std::ifstream stream(CANDELABRA_SOURCE_DIR "/tests/conformance/" + file);
    return nlohmann::json::parse(stream);
}

}  // namespace

TEST_CASE("pixels agree with POV-Ray 3.7's", "[render]") {
    const nlohmann::json cases = cases_of("povray.json");
    REQUIRE(cases.size() > 210);
    for (const auto& c : cases)
        check_pixels(
            c, c["scene"].get<std::string>().find("radiosity") == std::string::npos ? 0 : 20000);
}

TEST_CASE("scenes as people write them have POV-Ray 3.7's pixels", "[render]") {
    const nlohmann::json cases = cases_of("public_scenes.json");
    REQUIRE(cases.size() > 180);
    for (const auto& c : cases) check_pixels(c, 0);
}

TEST_CASE("radiosity agrees with POV-Ray 3.7's where that converges", "[render]") {
    const nlohmann::json cases = cases_of("radiosity.json");
    REQUIRE(cases.size() > 40);
    for (const auto& c : cases) check_pixels(c, 30000);
}

TEST_CASE("media agree with POV-Ray 3.7's where its sampling converges", "[render]") {
    const nlohmann::json cases = cases_of("media.json");
    REQUIRE(cases.size() > 100);
    for (const auto& c : cases) check_pixels(c, 256);
}

TEST_CASE("photons agree with POV-Ray 3.7's where these converge", "[render][photons]") {
    const nlohmann::json cases = cases_of("photons.json");
    REQUIRE(cases.size() == 38);
    for (const auto& c : cases) check_pixels(c, c.value("samples", 16));
}

}  // namespace candelabra
