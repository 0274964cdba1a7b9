// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_tree.h"

#include "support/draw.h"

#include <catch2/catch.hpp>
#include <set>

namespace candelabra {

namespace {

std::vector<Photon> photons_about(const Vec3& middle, int count) {
    Draw draw(4);
    std::vector<Photon> photons;
    for (int i = 0; i < count; ++i) {
        photons.push_back(
            {middle + draw.point(1), glm::vec3(0, -1, 0), glm::vec3(0), glm::vec3(1)});
        photons.back().radius = 0.1F;
        photons.back().lamp = Lamp::luminaire(static_cast<std::uint32_t>(i));
    }
    return photons;
}

}  // namespace

TEST_CASE("a walk finds all photons whose space holds a point", "[transport]") {
    const PhotonTree tree(photons_about(Vec3(0), 500), 0,
                          [](std::span<Photon>, int known) { return known; });
    REQUIRE(tree.photons().size() == 500);
    Draw draw(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 point = draw.point(1);
        const auto holds = [&](const Photon& photon) {
            return length(photon.position - point) < photon.radius;
        };
        std::set<std::uint32_t> found, expected;
        tree.walk([&](const Box& box) { return contains(box, point); },
                  [&](const Photon& photon) {
                      if (holds(photon)) found.insert(photon.lamp.index());
                  });
        for (const Photon& photon : tree.photons())
            if (holds(photon)) expected.insert(photon.lamp.index());
        CHECK(found == expected);
    }
    PhotonTree().walk([](const Box&) { return true; }, [](const Photon&) { FAIL(); });
}

TEST_CASE("both halves of a group are told what is known of it", "[transport]") {
    const auto check = [](std::span<Photon> photons, std::size_t whole) {
        CHECK((whole == 0 || photons.size() == whole / 2 || photons.size() == whole - whole / 2));
        return photons.size();
    };
    const PhotonTree tree(photons_about(Vec3(0), 333), std::size_t{0}, check);
    CHECK(tree.photons().size() == 333);
}

TEST_CASE("photons that stray do not move a group's middle, and have larger radii", "[transport]") {
    std::vector<Photon> photons = photons_about(Vec3(1, 2, 3), 99);
    photons.back().position = Vec3(1000);
    const PhotonGroup group = group_of(photons);
    CHECK(length(group.middle - Vec3(1, 2, 3)) < 0.3);
    CHECK(group.half < 1.5);
    set_radii(photons, group, 0.2, {.shrunk = 0.5});
    CHECK(photons.front().radius == Approx(0.1));
    CHECK(photons.back().radius > 10);
    set_radii(photons, group, 0.2, {.shrunk = 0.5, .radius = 4});
    for (const Photon& photon : photons) CHECK(photon.radius == 2);
    set_radii(photons, group, 0, {.unknown = 3});
    CHECK(photons.front().radius == 3);
}

}  // namespace candelabra
