// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/models.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("damaged cameras of Collada are read or left out", "[imports]") {
    for (const char* optics :
         {"<orthographic>", "<orthographic></orthographic>", "<perspective><yfov></perspective>",
          "<orthographic><xmag>much</xmag><ymag></orthographic>", "<yfov", "<orthographic><xmag",
          "<orthographic><xmag>1e999</xmag></orthographic>",
          "<orthographic><ymag>0</ymag><xmag>0</xmag></orthographic>"}) {
        INFO(optics);
        const Imported done = imported("a.dae", dae_of_camera(optics));
        if (done.problem.empty()) CHECK(done.model.cameras.size() <= 1);
    }
}

TEST_CASE("both sizes of a parallel camera of Collada count", "[imports]") {
    const Imported done = imported(
        "a.dae", dae_of_camera("<orthographic><xmag>3</xmag><ymag>2</ymag></orthographic>"));
    REQUIRE(done.model.cameras.size() == 1);
    CHECK(done.model.cameras[0].parallel);
    CHECK(done.model.cameras[0].height == Approx(4));
}

}  // namespace candelabra
