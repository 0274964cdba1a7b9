// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the table of a road: no crash, and a road that is read reflects a finite share of
// light from all sides.
#include "bind/road_tables.h"
#include "fuzz/target.h"

#include <cmath>
#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    RoadTable table;
    if (!read_road_table({reinterpret_cast<const char*>(data), size}, table).empty()) return 0;
    if (table.entries.size() != table.angles.size() * table.tangents.size()) std::abort();
    for (const double angle : table.angles)
        if (!(angle >= 0 && angle <= 180)) std::abort();
    for (const Vec3& light : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0.6, 0.8, 0),
                              Vec3(-0.6, 0.8, 0), Vec3(0.36, 0.8, 0.48), Vec3(0.8, 0.36, -0.48)}) {
        const double share = table.coefficient(Vec3(0, 1, 0), Vec3(1, 0, 0), light);
        if (!(share >= 0 && std::isfinite(share))) std::abort();
    }
    return 0;
}
