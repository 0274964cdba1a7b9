// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/light_recorder.h"

#include "relight/relighting.h"
#include "render/render.h"
#include "support/four_lamps.h"

#include <catch2/catch.hpp>

#include <memory>

namespace candelabra {

namespace {

std::vector<std::string> names_for(const World& world) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < world.provenance.light_statements.size(); ++i)
        names.push_back("Lamp" + std::to_string(i));
    return names;
}

struct Recorded {
    Image image;
    LightRecords records;
};

/// The light of a picture's lamps. `pause`: the run is stopped and continued after so many
/// questions whether to stop.
Recorded recorded(const std::string& script, const RenderSettings& settings,
                  std::uint64_t bytes = 0, int pause = 0) {
    const Shot shot = shot_of(script);
    WorldLamps lamps = world_lamps(*shot.world, names_for(*shot.world));
    RecordPlan plan{settings.width, settings.height, bytes, 0};
    if (bytes == 0) plan.bytes = usual_record_bytes(settings.width, settings.height);
    LightRecorder recorder(std::move(lamps), plan);
    RenderHooks hooks;
    hooks.lamps = &recorder;
    int asked = 0;
    if (pause > 0) hooks.cancelled = [&] { return ++asked % pause == 0; };
    RenderState state = begin_picture(settings);
    LightLedger rays;
    const RenderPlan rendering = plan_of(shot, settings);
    while (!advance(rendering, state, rays, hooks)) {
    }
    return {state.film.image(), recorder.finish(state.film, settings.threads)};
}

/// The greatest difference of a pixel, in terms of its brightest channel.
double difference(const Image& a, const Image& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double off = max_abs_component(a.pixels[i] - b.pixels[i]);
        if (off > 0) most = std::max(most, off / max_abs_component(a.pixels[i]));
    }
    return most;
}

const char* const three_lamps = R"(
    #version 3.7;
    camera { location <0, 3, -8> look_at <0, 1, 0> right x up y angle 50 }
    plane { y, 0 pigment { rgb <0.9, 0.7, 0.5> } finish { ambient 0 diffuse 0.8 } }
    plane { x, 4 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.3 reflection 0.6 } }
    #ifndef (W) #declare W = array[3] { 1, 1, 1 }; #end
    sphere { <-2, 1, 0>, 0.4 pigment { rgb 1 } finish { diffuse 0 emission rgb 6*W[0] } }
    sphere { <0, 1, 2>, 0.3 pigment { rgb <1, 0.5, 0> } finish { diffuse 0 emission 6*W[1] } }
    light_source { <2, 4, -2>, rgb W[2] }
)";

}  // namespace

TEST_CASE("the picture is that of its records at the powers rendered", "[relight]") {
    for (const char* more : {"", "global_settings { integrator { path_traced } }"}) {
        INFO(more);
        const Recorded made = recorded(std::string(three_lamps) + more, of_samples(8));
        CHECK(made.records.lamps.size() == 3);
        const Image same = relit(made.records, std::vector<Rgb>(3, Rgb(1)), 1);
        CHECK(difference(made.image, same) < 1e-3);
    }
}

TEST_CASE("keeping light changes no picture", "[relight]") {
    RenderSettings settings = of_samples(8);
    const Image plain = render(shot_of(four_lamps), settings).image;
    CHECK(recorded(four_lamps, settings).image.pixels == plain.pixels);
}

TEST_CASE("records do not depend on threads and pauses", "[relight]") {
    // Light that is sent from lamps serves 32 samples, so there are two passes.
    RenderSettings settings = of_samples(36);
    settings.width = 20;
    settings.height = 13;
    constexpr std::uint64_t small_file = 9000;
    const std::string paths =
        std::string(four_lamps) + "global_settings { integrator { path_traced } }";
    for (const std::string& script : {std::string(four_lamps), paths}) {
        settings.threads = 1;
        const LightRecords once = recorded(script, settings, small_file).records;
        settings.threads = 3;
        CHECK(recorded(script, settings, small_file).records == once);
        for (const int pause : {7, 50}) {
            INFO(pause);
            CHECK(recorded(script, settings, small_file, pause).records == once);
        }
    }
}

TEST_CASE("records keep to a noise, in rounds", "[relight]") {
    RenderSettings settings = of_samples(0);
    settings.noise = 0.02;
    const Recorded made = recorded(four_lamps, settings, 60000);
    const Image same = relit(made.records, std::vector<Rgb>(12, Rgb(1)), 1);
    CHECK(difference(made.image, same) < 1e-3);
}

TEST_CASE("a small file has the mean light of a large one", "[relight]") {
    const RenderSettings settings = of_samples(64);
    const Recorded large = recorded(four_lamps, settings),
                   small = recorded(four_lamps, settings, 20000);
    std::vector<Rgb> factors;
    for (int i = 0; i < 12; ++i) factors.emplace_back(i % 3 == 0 ? 1.0 : 0.0, 1.0, i / 12.0);
    const auto mean = [](const Image& image) {
        Rgb sum(0);
        for (const Rgb& pixel : image.pixels) sum += pixel;
        return sum / static_cast<double>(image.pixels.size());
    };
    const Rgb right = mean(relit(large.records, factors, 1)),
              made = mean(relit(small.records, factors, 1));
    for (int c = 0; c < 3; ++c) CHECK(made[c] == Approx(right[c]).epsilon(0.03));
}

TEST_CASE("a recorder goes on from its bytes as if it had never stopped", "[relight]") {
    const RenderSettings settings = of_samples(8);
    const Shot shot = shot_of(three_lamps);
    RecordPlan plan{settings.width, settings.height, 0, 0};
    const auto lamps = [&] { return world_lamps(*shot.world, names_for(*shot.world)); };
    plan.bytes = least_record_bytes(plan, lamps().list) + 100;
    const RenderPlan rendering = plan_of(shot, settings);
    const auto made = [&](int pause) {
        auto recorder = std::make_unique<LightRecorder>(lamps(), plan);
        RenderState state = begin_picture(settings);
        RenderHooks hooks;
        LightLedger rays;
        int asked = 0;
        if (pause > 0) hooks.cancelled = [&] { return ++asked % pause == 0; };
        hooks.lamps = recorder.get();
        while (!advance(rendering, state, rays, hooks)) {
            auto next = std::make_unique<LightRecorder>(lamps(), plan);
            REQUIRE(next->go_on(recorder->state(2)));
            recorder = std::move(next);
            hooks.lamps = recorder.get();
        }
        return recorder->finish(state.film, 1);
    };
    const LightRecords whole = made(0);
    CHECK(made(5) == whole);
    CHECK(made(23) == whole);
    LightRecorder recorder(lamps(), plan);
    const std::string bytes = recorder.state(1);
    CHECK(recorder.go_on(bytes));
    CHECK_FALSE(recorder.go_on(bytes + "x"));
    CHECK_FALSE(recorder.go_on(""));
    for (std::size_t size = 0; size < bytes.size(); size += 7)
        REQUIRE_FALSE(LightRecorder::of_state(bytes.substr(0, size)));
    RecordPlan other = plan;
    other.bytes += 10000;
    CHECK_FALSE(LightRecorder(lamps(), other).go_on(bytes));
}

}  // namespace candelabra
