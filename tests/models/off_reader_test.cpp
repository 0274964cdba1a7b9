// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/read_text.h"

namespace candelabra {

TEST_CASE("OFF files may have comments, and more than places", "[models]") {
    for (const char* text :
         {"OFF # a triangle\n3 1 0\n# points\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n",
          "COFF 3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n",
          "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 0.5\n"}) {
        CAPTURE(text);
        const auto read = read_text("off", text);
        CHECK(read.wrong == "");
        CHECK(read.shape.points.size() == 3);
        CHECK(read.shape.faces == std::vector<Polyhedron::Face>{{0, 1, 2}});
    }
}

TEST_CASE("OFF files that say they are large have what they say, or are refused", "[models]") {
    CHECK(read_text("off", "OFF\n4000000000 1 0\n0 0 0\n").wrong ==
          "point 1 of 4000000000 is damaged, or missing");
    CHECK(read_text("off", "OFF\n1 4000000000 0\n0 0 0\n3 0 0 0\n").wrong ==
          "face 1 of 4000000000 is damaged, or missing");
    CHECK(read_text("off", "OFF\n1 1 0\n0 0 0\n4000000000 0 0\n").wrong ==
          "face 0 of 1 is damaged, or missing");
    CHECK(read_text("off", "OFF\n1 1 0\nnan 0 0\n3 0 0 0\n").wrong ==
          "a number of entry 0 is not finite");
    CHECK(read_text("off", "OFF BINARY\n").wrong != "");
    CHECK(read_text("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n").wrong != "");
}

}  // namespace candelabra
