// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/response.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace candelabra {

namespace {

struct CurvePoint {
    double exposure, filmic, agx;
};

/// Computed independently of the program, from the formulas of the sources.
constexpr CurvePoint curve_points[] = {
    {0.001, 0.0011216463306467958, 4.790657936735761e-05},
    {0.01, 0.011212843121201254, 0.003236659554772241},
    {0.05, 0.05499231406810284, 0.044226445921254416},
    {0.18, 0.18, 0.18},
    {0.5, 0.40180072484507334, 0.3698408005309577},
    {1, 0.6129469027105334, 0.5304101034565805},
    {2, 0.8306867200828927, 0.6922357299357822},
    {5, 1, 0.8660114993871182},
    {10, 1, 0.9555508092573235},
    {16.29, 1, 0.9999916606953767},
    {20, 1, 1},
    {100, 1, 1},
};

}  // namespace

TEST_CASE("the response curves have the numbers of their formulas", "[film][response]") {
    for (const CurvePoint& point : curve_points) {
        INFO("exposure " << point.exposure);
        CHECK(filmic_curve(point.exposure) == Approx(point.filmic).epsilon(1e-10));
        CHECK(agx_curve(point.exposure) == Approx(point.agx).epsilon(1e-10));
        const Rgb grey = respond(ResponseCurve::agx, Rgb(point.exposure));
        CHECK(grey.r == Approx(point.agx).epsilon(1e-10));
        CHECK(grey.g == Approx(grey.b).epsilon(1e-12));
    }
}

TEST_CASE("bright colours become white with agx, in steps that are known", "[film][response]") {
    const Rgb dim = respond(ResponseCurve::agx, {0.1, 0.02, 0.02}),
              bright = respond(ResponseCurve::agx, {10, 0.2, 0.2}),
              lamp = respond(ResponseCurve::agx, {100, 2, 2}),
              sun = respond(ResponseCurve::agx, {1000, 20, 20}),
              sign = respond(ResponseCurve::agx, {4, 0.8, 1.2});
    CHECK(dim.r == Approx(0.10129845743519102).epsilon(1e-9));
    CHECK(dim.g == Approx(0.018321292848260392).epsilon(1e-9));
    CHECK(bright.r == Approx(0.9656777950865603).epsilon(1e-9));
    CHECK(bright.g == Approx(0.27916634377043764).epsilon(1e-9));
    CHECK(lamp.r == Approx(1));
    CHECK(lamp.g == Approx(0.8473353840221882).epsilon(1e-9));
    CHECK(sun.g == Approx(0.9891968503937009).epsilon(1e-9));
    // A small sign of coloured letters is not pale.
    CHECK(sign.g / sign.r == Approx(0.39193).epsilon(1e-4));
    const Rgb clipped = respond(ResponseCurve::linear, {100, 0.5, -1});
    CHECK(clipped == Rgb(1, 0.5, 0));
}

TEST_CASE("more light never shows as less, and all is within a display", "[film][response]") {
    double filmic = 0, agx = 0;
    for (double exposure = 1e-6; exposure < 1e9; exposure *= 1.07) {
        CHECK(filmic_curve(exposure) >= filmic);
        CHECK(agx_curve(exposure) >= agx);
        filmic = filmic_curve(exposure);
        agx = agx_curve(exposure);
    }
    CHECK(filmic == 1);
    CHECK(agx == 1);
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const ResponseCurve curve :
         {ResponseCurve::linear, ResponseCurve::filmic, ResponseCurve::agx})
        for (const Rgb& strange : {Rgb(inf), Rgb(-inf, 1, 0), Rgb(NAN), Rgb(NAN, 1e300, -5),
                                   Rgb(1e300), Rgb(0), Rgb(inf, 0, 0)}) {
            const Rgb shown = respond(curve, strange);
            for (int c = 0; c < 3; ++c) CHECK((shown[c] >= 0 && shown[c] <= 1));
        }
    CHECK(respond(ResponseCurve::agx, Rgb(0)) == Rgb(0));
    CHECK(respond(ResponseCurve::filmic, Rgb(0)) == Rgb(0));
}

}  // namespace candelabra
