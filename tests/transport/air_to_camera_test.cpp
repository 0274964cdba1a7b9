// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_to_camera.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

namespace candelabra {

TEST_CASE("air dims light on the straight way to the camera", "[transport]") {
    const LitRegion region{Vec3(0, 0, 4), 1.5, 1e5};
    const auto left = [&](const std::string& scene) {
        return AirToCamera(shot_of("#version 3.7; " + scene), region).transmittance(Vec3(0, 0, 9));
    };
    const std::string camera = "camera { location 2*z } ",
                      parallel = "camera { orthographic location 2*z look_at 3*z } ";
    CHECK(left(camera) == 1);
    CHECK(left(camera + "media { absorption <0.4, 0.2, 0.3> }") == Approx(std::exp(-0.2 * 7)));
    CHECK(left(camera + "media { absorption 0.1 } media { absorption 0.2 }") ==
          Approx(std::exp(-0.3 * 7)));
    CHECK(left(parallel + "media { absorption 0.2 }") == Approx(std::exp(-0.2 * 3.5)));
    // Nobody knows how thick air with a pattern is on the way.
    CHECK(left(camera + "media { absorption 0.2 density { bozo } }") == 1);
}

}  // namespace candelabra
