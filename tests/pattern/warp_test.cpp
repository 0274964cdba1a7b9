// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/warp.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("warps and transformations lead where POV-Ray's do", "[pattern]") {
    struct Row {
        std::string text;
        std::array<Vec3, 3> places;
    };
    const std::vector<Row> rows = {
        {"turbulence 0.5 scale 2 translate <1,2,3>",
         {Vec3(-0.2191119, -0.5623606, -1.5227251), Vec3(0.1563023, 0.3143706, 0.2254671),
          Vec3(-1.9417527, -0.5964994, -5.3694618)}},
        {"scale 2 warp{turbulence 0.5 octaves 3 lambda 2.5 omega 0.3} translate <1,2,3>",
         {Vec3(-0.3402744, -0.5505421, -1.5846496), Vec3(0.2087775, 0.3861188, 0.4292732),
          Vec3(-1.7508037, -0.8183171, -5.3687354)}},
        {"warp{repeat 2*y flip <1,1,0> offset <0.3,0.1,0.2>}",
         {Vec3(0.3000000, 0.7000000, -0.2000000), Vec3(-1.0000000, 1.4000000, 4.1000000),
          Vec3(-2.4500000, 0.1500000, -7.6000000)}},
        {"warp{black_hole <1,2,3>,5 strength 3 falloff 1.5 inverse}",
         {Vec3(0.6367477, 1.3253886, 1.3394181), Vec3(1.0000000, 2.0000000, 3.0000000),
          Vec3(-2.4500000, 0.1500000, -7.6000000)}},
        {"warp{black_hole <0,0,0>,1 repeat <3,0,5> turbulence <.5,.2,.3> falloff 1}",
         {Vec3(0.3000000, 0.7000000, -0.2000000), Vec3(1.3000000, 2.7000000, 3.9000000),
          Vec3(-2.4500000, 0.1500000, -7.6000000)}},
        {"warp{cylindrical orientation y dist_exp 1}",
         {Vec3(0.3268131, -0.3605551, 0.7000000), Vec3(0.8172254, -4.1109610, 2.7000000),
          Vec3(5.5925346, -7.9851425, 0.1500000)}},
        {"warp{spherical}",
         {Vec3(0.9064165, 0.8485998, 0.7874008), Vec3(0.1987918, 0.6849785, 4.9183331),
          Vec3(0.7003675, 0.5059787, 7.9865512)}},
        {"warp{toroidal orientation y dist_exp 1 major_radius 2}",
         {Vec3(1.6158077, -1.7826327, 1.6681421), Vec3(0.6813125, -3.4272666, 2.2084961),
          Vec3(4.1931158, -5.9870218, 3.0173866)}},
        {"warp{planar x,2.5}",
         {Vec3(2.5000000, 0.7000000, -0.3000000), Vec3(2.5000000, 2.7000000, -1.3000000),
          Vec3(2.5000000, 0.1500000, 2.4500000)}},
        {"warp{cubic}",
         {Vec3(0.4285714, 0.8809524, 0.7000000), Vec3(0.4166667, 0.6153846, 3.9000000),
          Vec3(0.9152961, 0.5032895, 7.6000000)}},
    };
    const std::array<Vec3, 3> points = {Vec3(0.3, 0.7, -0.2), Vec3(1.3, 2.7, 3.9),
                                        Vec3(-2.45, 0.15, -7.6)};
    for (const Row& row : rows) {
        INFO(row.text);
        const PatternUse use = pattern_of("bozo " + row.text);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                CHECK(use.place(points[i])[axis] ==
                      Approx(row.places[i][axis]).margin(1e-7).epsilon(0));
    }
}

TEST_CASE("steps are undone from the last to the first", "[pattern]") {
    RepeatWarp repeat;
    repeat.width = Vec3(2, 0, 0);
    const std::vector<WarpStep> steps = {Transform::translation(Vec3(1, 0, 0)), Warp(repeat),
                                         Transform::scaling(Vec3(10))};
    CHECK(warped(steps, Vec3(35, 5, 0)) == Vec3(3.5 - 2 - 1, 0.5, 0));
}

TEST_CASE("a point for which a warp has no answer stays", "[pattern]") {
    for (const Warp& warp : {Warp(CylindricalWarp{}), Warp(SphericalWarp{}), Warp(CubicWarp{})})
        CHECK(warped(warp, Vec3(0)) == Vec3(0));
    CHECK(warped(Warp(ToroidalWarp{}), Vec3(1, 0, 0)) == Vec3(1, 0, 0));
}

TEST_CASE("places stay within reach", "[pattern]") {
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK(within_reach(Vec3(infinite, -infinite, 3)) == Vec3(1e17, -1e17, 3));
    CHECK(within_reach(Vec3(NAN, 0, 0)).x == -1e17);
    TurbulenceWarp wild;
    wild.amount = Vec3(1e300);
    const std::vector<WarpStep> steps = {Warp(wild)};
    CHECK(max_abs_component(warped(steps, Vec3(0.5))) <= 1e17);
}

TEST_CASE("a repeated black hole is moved to where its blocks can hold it", "[pattern]") {
    BlackHole hole;
    hole.centre = Vec3(0.2, 5, 0);
    hole.repeat = Vec3(1, 9, 0);
    hole.turbulence = Vec3(0.5, 0, 0);
    fit_blocks(hole);
    CHECK(hole.centre == Vec3(1, 5, 0));
    CHECK(hole.repeat == Vec3(2.5, 9, 0));
}

}  // namespace candelabra
