// SPDX-License-Identifier: GPL-3.0-or-later
#include "method/settings.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("POV-Ray's way of following light is the default", "[method]") {
    CHECK(Kinds<IntegratorSettings>::infos[0]->name == "pov_ray");
    CHECK(std::holds_alternative<PovRay>(IntegratorSettings()));
    CHECK(PathTraced().bounces == 8);
}

}  // namespace candelabra
