// SPDX-License-Identifier: GPL-3.0-or-later
// Each light sampling strategy gives the picture that a shadow ray to every luminaire gives: pixel
// by pixel and on the whole, in small scenes that are hard on it.
#include "render/render.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

namespace candelabra {

namespace {

constexpr int strategy_size = 12;
constexpr int runs = 24;

/// Mean and its variance, from independent runs.
struct Estimate {
    double mean = 0, variance = 0;
};

struct Estimates {
    std::vector<Estimate> pixels;
    Estimate whole;
};

Estimate estimate(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double v : values) sum += v;
    const double n = static_cast<double>(values.size());
    for (const double v : values) squares += (v - sum / n) * (v - sum / n);
    return {sum / n, squares / (n - 1) / n};
}

Estimates render_often(const Shot& shot, int samples) {
    RenderSettings settings;
    settings.width = settings.height = strategy_size;
    settings.antialias = false;
    settings.samples = samples;
    settings.shadow_rays = 1;
    std::vector<std::vector<double>> pixels(strategy_size * strategy_size);
    std::vector<double> whole;
    for (settings.seed = 0; settings.seed < runs; ++settings.seed) {
        const Image image = render(shot, settings).image;
        double sum = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            pixels[i].push_back(grey(image.pixels[i]));
            sum += pixels[i].back();
        }
        whole.push_back(sum);
    }
    Estimates result;
    for (const auto& values : pixels) result.pixels.push_back(estimate(values));
    result.whole = estimate(whole);
    return result;
}

/// How many standard deviations two estimates are apart. Some luminaires have no noise of their
/// own, so that rare choices of others may be all the noise there is, and not seen yet: that much
/// may be missing.
double deviations(const Estimate& a, const Estimate& b, double unseen) {
    return std::abs(a.mean - b.mean) / std::sqrt(a.variance + b.variance + unseen * unseen);
}

std::string script(const std::string& name) {
    std::ifstream file(CANDELABRA_SOURCE_DIR "/tests/statistics/" + name + ".pov");
    REQUIRE(file);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("every strategy agrees with a shadow ray to every luminaire and light source",
          "[statistics][claim-1][claim-33][claim-34]") {
    struct Case {
        const char* name;
        int exact_samples = 16, samples = 64;
    };
    for (const auto& [name, exact_samples, samples] :
         {Case{"spheres"}, Case{"horizon"}, Case{"shapes"}, Case{"inside"}, Case{"crowd"},
          Case{"windows"}, Case{"glossy"}, Case{"clear"}, Case{"dim"}, Case{"sources", 1, 48}}) {
        const Scene scene = scene_of(script(name));
        const auto shot_with = [&](const LightSampler& sampler) {
            return Shot(world_of(scene, sampler));
        };
        const Estimates exact = render_often(shot_with(EveryLight{}), exact_samples);
        REQUIRE(exact.whole.mean > 0.1);
        LightOctree paper, alone, surface, short_cut;
        paper.paper = true;
        alone.alone = true;
        surface.outlook = 0.5;
        short_cut.cut = 8;
        LightBvh pair;
        pair.mis = true;
        std::vector<LightSampler> samplers = {paper, alone, surface, short_cut, pair};
        for (std::size_t i = 1; i < Kinds<LightSampler>::count; ++i)
            samplers.push_back(Kinds<LightSampler>::make(i));
        for (const LightSampler& sampler : samplers) {
            const Estimates found = render_often(shot_with(sampler), samples);
            INFO(name << ", " << Kinds<LightSampler>::infos[sampler.index()]->name << ": "
                      << found.whole.mean << " instead of " << exact.whole.mean);
            CHECK(deviations(found.whole, exact.whole, 1e-6) < 4.5);
            const double mean = exact.whole.mean / (strategy_size * strategy_size);
            // 144 pixels, 9 strategies and 10 scenes: so far out only once in thousands of runs of
            // this test.
            for (std::size_t p = 0; p < exact.pixels.size(); ++p) {
                INFO("pixel " << p << ": " << found.pixels[p].mean << " instead of "
                              << exact.pixels[p].mean);
                const double unseen = 1e-3 * (mean + exact.pixels[p].mean);
                CHECK(deviations(found.pixels[p], exact.pixels[p], unseen) < 8);
            }
        }
    }
}

}  // namespace candelabra
