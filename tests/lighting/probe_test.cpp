// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/probe.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace candelabra {

TEST_CASE("what is behind clear things is seen, as far as light passes them", "[lighting]") {
    // Panes at 1, 2, 3 ..., each of which transmits half of the light, up to the first opaque one.
    double opaque = 4;
    const auto pane = [&](const Ray&, double tolerance) -> std::optional<ProbeHit> {
        const double t = std::floor(tolerance + 1e-6) + 1;
        return ProbeHit{t, Vec3(0, 1, 0), 1e-9, {}, 1, t < opaque ? 0.5 : 0};
    };
    std::vector<double> shares;
    const auto note = [&](const ProbeHit& seen, double share) {
        CHECK(seen.distance == static_cast<double>(shares.size()) + 1);
        shares.push_back(share);
        return shares.size() == 6;
    };
    look_along({Vec3(0), Vec3(0, 0, 1)}, 0, pane, note);
    CHECK(shares == std::vector<double>{1, 0.5, 0.25, 0.125});
    shares.clear();
    opaque = 1e9;
    look_along({Vec3(0), Vec3(0, 0, 1)}, 0, pane, note);
    CHECK(shares.size() == 6);
    int visited = 0;
    look_along({Vec3(0), Vec3(0, 0, 1)}, 0, pane, [&](const ProbeHit&, double) {
        ++visited;
        return false;
    });
    CHECK(visited < 100);
}

}  // namespace candelabra
