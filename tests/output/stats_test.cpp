// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/stats.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candelabra {

TEST_CASE("the statistics hold everything under its name") {
    RunStatistics run;
    run.parse = {1, 2};
    run.render = {3, 6};
    run.total = {5, 9};
    run.objects = 7;
    run.luminaires = 5;
    run.rays = {200, 300, 400};
    run.lights = {{"Lamp", "a.pov:3: object { Lamp }", 0.75, 0.5, 4}};
    run.index = "kd_tree";
    run.tree.bytes = 1000;
    run.tree.leaves = 30;
    run.tree.max_depth = 2;
    run.tree.references = 90;
    run.light_octree_bytes = 2000;
    run.peak_memory_bytes = 3000;
    run.light_sampler = "light_octree";
    run.seed = 11;
    run.threads = 2;
    run.width = 10;
    run.height = 5;
    run.samples = 4;
    const auto json = nlohmann::json::parse(to_json(run));
    for (const char* part : {"parse", "compile", "render", "total"}) {
        CHECK(json["seconds"][part].is_number());
        CHECK(json["cpu_seconds"][part].is_number());
    }
    CHECK(json["seconds"]["render"] == 3);
    CHECK(json["cpu_seconds"]["render"] == 6);
    CHECK(json["objects"] == 7);
    CHECK(json["luminaires"] == 5);
    CHECK(json["rays"] == nlohmann::json({{"camera", 200}, {"shadow", 300}, {"scattered", 400}}));
    CHECK(json["lights"] == nlohmann::json({{{"name", "Lamp"},
                                             {"statement", "a.pov:3: object { Lamp }"},
                                             {"light", 0.75},
                                             {"rays", 0.5},
                                             {"lights", 4}}}));
    CHECK(json["index"] == "kd_tree");
    CHECK(json["kdtree"]["bytes"] == 1000);
    CHECK(json["kdtree"]["cells"] == 30);
    CHECK(json["kdtree"]["depth"] == 2);
    CHECK(json["kdtree"]["references"] == 90);
    CHECK_FALSE(json.contains("bounding_boxes"));
    CHECK(json["light_octree"]["bytes"] == 2000);
    CHECK(json["peak_memory_bytes"] == 3000);
    CHECK(json["light_sampler"] == "light_octree");
    CHECK(json["seed"] == 11);
    CHECK(json["threads"] == 2);
    CHECK(json["width"] == 10);
    CHECK(json["height"] == 5);
    CHECK(json["samples"] == 4);
    CHECK(json["samples_per_pixel"] == 4);
}

TEST_CASE("a run that rendered nothing has statistics, too") {
    CHECK(nlohmann::json::parse(to_json({}))["samples_per_pixel"] == 0);
}

TEST_CASE("counts are told in a few characters") {
    struct Case {
        double count;
        const char* expected;
    };
    const Case cases[] = {{0, "0"},         {950, "950"},      {999, "999"},
                          {1000, "1.0 k"},  {12345, "12.3 k"}, {999960, "1.0 M"},
                          {4.5e6, "4.5 M"}, {1.23e9, "1.2 G"}, {5e15, "5000.0 T"}};
    for (const Case& each : cases) CHECK(short_count(each.count) == each.expected);
}

TEST_CASE("the summary fits on a line") {
    RunStatistics run;
    run.width = 640;
    run.height = 480;
    run.total.seconds = 12.3;
    run.objects = 7382;
    run.luminaires = 1;
    run.light_sampler = "light_octree";
    run.rays = {2'100'000, 9'700'000, 0};
    CHECK(summary(run) ==
          "640 x 480 in 12 s: 7382 objects, 1 luminaire (light_octree); 2.1 M camera, 9.7 M "
          "shadow, 0 scattered rays");
}

TEST_CASE("clocks run forward and memory is used") {
    const Phase before = time_now();
    volatile double sum = 0;
    for (int i = 0; i < 100000; ++i) sum = sum + i;
    const Phase passed = time_now() - before;
    CHECK(passed.seconds > 0);
    CHECK(passed.cpu_seconds > 0);
    CHECK(peak_memory_bytes() > 100000);
}

}  // namespace candelabra
