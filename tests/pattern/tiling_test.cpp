// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/tiling.h"

#include "pattern/values.h"

#include <set>

namespace candelabra {

TEST_CASE("tilings have POV-Ray's values", "[pattern]") {
    struct Row {
        int type;
        std::array<double, 4> values;
    };
    const std::vector<Row> rows = {
        {1, {0.600000, 0.820000, 0.200000, 0.660000}},
        {2, {0.769060, 0.887440, 0.224276, 0.958401}},
        {3, {0.723205, 0.331159, 0.906793, 0.937602}},
        {4, {0.538120, 0.774879, 0.875724, 0.916803}},
        {5, {0.876980, 0.591626, 0.891908, 0.972268}},
        {6, {0.300000, 0.410000, 0.100000, 0.330000}},
        {7, {0.500000, 0.319310, 0.500000, 0.649605}},
        {8, {0.482137, 0.794522, 0.509745, 0.803701}},
        {9, {0.482137, 0.220773, 0.666667, 0.730799}},
        {10, {0.600000, 0.820000, 0.200000, 0.660000}},
        {11, {0.533333, 0.606667, 0.700000, 0.553333}},
        {12, {0.866667, 0.606667, 0.700000, 0.860000}},
        {13, {0.600000, 0.000000, 0.690118, 0.754632}},
        {14, {0.760000, 0.800000, 0.214071, 0.052779}},
        {15, {0.800000, 0.410000, 0.600000, 0.330000}},
        {16, {0.306538, 0.666667, 0.000000, 0.135783}},
        {17, {0.486603, 0.833333, 0.333333, 0.234558}},
        {18, {0.300000, 0.410000, 0.600000, 0.790000}},
        {19, {0.482137, 0.220773, 0.837862, 0.625068}},
        {20, {0.769060, 0.666667, 0.937862, 0.666667}},
        {21, {0.103269, 0.164372, 0.720065, 0.968212}},
        {22, {0.666667, 0.901236, 0.666667, 0.666667}},
        {23, {0.666667, 0.768081, 0.153418, 0.210602}},
        {24, {0.800000, 0.860849, 0.092051, 0.126361}},
    };
    const std::array<Vec3, 4> points = {Vec3(0.3, 9, -0.2), Vec3(1.37, 8, 3.91),
                                        Vec3(-2.45, 7, -7.6), Vec3(5.21, 6, 0.83)};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < points.size(); ++i) {
            INFO("tiling " << row.type << ", point " << i);
            CHECK(evaluate(Tiling{row.type}, points[i]) ==
                  Approx(row.values[i]).margin(1.1e-6).epsilon(0));
        }
}

TEST_CASE("tilings cover the plane without gaps", "[pattern]") {
    // In a gap, the nearest tile would be chosen, and values would exceed those of any tile.
    for (int type = 1; type <= 24; ++type)
        for (int i = 0; i < 2000; ++i) {
            const double value = evaluate(Tiling{type}, {i * 0.137 - 90, 0, i * -0.291 + 7});
            INFO("tiling " << type << ", point " << i);
            CHECK((value >= 0 && value <= 1 + 1e-6));
        }
}

}  // namespace candelabra
