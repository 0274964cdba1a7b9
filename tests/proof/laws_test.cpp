// SPDX-License-Identifier: GPL-3.0-or-later
// Laws on some scenes with a fixed seed; run.sh goes on from there.
#include "base/deep_stack.h"
#include "proof/laws.h"
#include "proof/runner.h"
#include "world/shot.h"

#include <catch2/catch.hpp>

namespace candelabra::proof {

TEST_CASE("laws hold on the first scenes of the generator", "[proof]") {
    Plan plan;
    for (const Law& law : laws()) plan.laws.push_back(&law);
    plan.scenes = 3;
    plan.seed = 2;  // no claim of its scenes needs many samples
    plan.studio.look_seconds = 3;
    plan.shrink_minutes = 0;
    on_deep_stack(std::size_t{64} << 20, [&](std::size_t) {
        Listening listening;
        listening.fault = [](const Fault& fault) {
            INFO(fault.law << ": " << described(fault.verdict) << "\n" << fault.script);
            CHECK(fault.known != "");
        };
        for (const LawCount& each : run(plan, listening)) {
            INFO(each.law);
            CHECK(each.scenes == plan.scenes);
            CHECK(each.illegal == 0);
            CHECK(each.slow <= 2);
        }
    });
}

TEST_CASE("most scenes with unions in many places store them once", "[proof]") {
    Studio sharing;
    sharing.instances = {2, 1000, 2};
    int shared = 0, with_lamps = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Draft draft = drafted(Row(factors().size(), 0), seed);
        const Script script = with_copies(draft);
        const Prepared scene(sharing, written(script), script.options);
        REQUIRE(scene.trouble() == Trouble::none);
        const World& world = *scene.shot().world;
        shared += world.geometry.instances.empty() ? 0 : 1;
        with_lamps += !world.geometry.instances.empty() && world.lights.glowing() > 0 ? 1 : 0;
    }
    CHECK(shared >= 15);
    CHECK(with_lamps >= 5);
}

}  // namespace candelabra::proof
