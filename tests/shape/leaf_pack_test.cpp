// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/leaf_pack.h"

#include "index/tree_builder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Spheres, then triangles, then boxes.
struct Things {
    std::vector<Sphere> spheres;
    std::vector<Triangle> triangles;
    std::vector<Box> boxes;

    std::size_t size() const { return spheres.size() + triangles.size() + boxes.size(); }
    PackedKinds kinds() const {
        const auto first = static_cast<std::uint32_t>(spheres.size());
        const auto last = first + static_cast<std::uint32_t>(triangles.size());
        return {first, last,
                [this](std::uint32_t i) {
                    return PackedKinds::Ball{spheres[i].centre, spheres[i].radius};
                },
                [this, first](std::uint32_t i) {
                    const Triangle& t = triangles[i - first];
                    return std::array{t.corner1, t.corner2, t.corner3};
                },
                [this, last](std::uint32_t i) { return boxes[i - last]; }};
    }
    /// Parameter at which the ray hits the item; range.max when it does not.
    double meet(std::uint32_t item, const Ray& ray, const Interval& range) const {
        if (item >= spheres.size() + triangles.size()) {
            const Box& box = boxes[item - spheres.size() - triangles.size()];
            const Interval within = clip(ray, box, range);
            return within.min < within.max ? within.min : range.max;
        }
        if (item < spheres.size())
            return first_crossing(spheres[item].centre, spheres[item].radius, ray, range);
        const Triangle& t = triangles[item - spheres.size()];
        return first_crossing(t.corner1, t.corner2, t.corner3, ray, range).t;
    }
};

/// Things in a ball of this size around the centre; some are a thousand times larger or smaller.
Things scattered(std::size_t count, const Vec3& centre, double size, Draw& draw) {
    Things made;
    for (std::size_t i = 0; i < count; ++i) {
        const double own = size * 0.2 * (i % 7 == 0 ? std::pow(10, draw.between(-3, 3)) : 1);
        const Vec3 place = centre + size * draw.point() + (own > size ? own : 0) * draw.direction();
        made.spheres.push_back({place, own});
        made.triangles.push_back(
            {place + own * draw.point(), place + own * draw.point(), place + own * draw.point()});
        const Vec3 corner = place + own * draw.point(), flat = i % 3 == 0 ? Vec3(1, 0, 1) : Vec3(1);
        made.boxes.push_back(join(Box{corner, corner}, corner + flat * (own * draw.point())));
    }
    return made;
}

/// All things, at most eight in a leaf; by their boxes, each may be anywhere.
WideTree packed(const Things& things, const Box& around) {
    WideTree tree = build_tree(std::vector<Box>(things.size(), around), {}, 1);
    tree.pack(leaf_packs(things.kinds()), 1);
    return tree;
}

struct Candidates {
    std::vector<bool> asked;
    std::size_t count = 0;
};

Candidates candidates(const WideTree& tree, const Things& things, const Ray& ray,
                      const Interval& range) {
    Candidates found{std::vector<bool>(things.size())};
    PackRay packed(ray);
    tree.traverse(ray, range, [&](const TreeLeaf& leaf, const Interval& whole) {
        return packed.candidates(leaf, whole, [&](std::uint32_t item) {
            found.asked[item] = true;
            ++found.count;
            return false;
        });
    });
    return found;
}

/// Whether the leaf blocks the ray, and the number of items in doubt that were tested.
struct Blocked {
    bool blocked = false;
    std::size_t asked = 0;
};

Blocked blocked(const WideTree& tree, const Things& things, const Ray& ray, const Interval& range) {
    Blocked found;
    PackRay packed(ray);
    found.blocked = tree.traverse(ray, range, [&](const TreeLeaf& leaf, const Interval& whole) {
        return packed.blocked(leaf, whole, [&](std::uint32_t item) {
            ++found.asked;
            return things.meet(item, ray, range) < range.max;
        });
    });
    return found;
}

/// A ray from anywhere to a point in the middle, to a sphere's rim or to a triangle's edge.
Ray aimed(const Things& things, const Vec3& centre, double size, Draw& draw) {
    const double far = std::pow(10, draw.between(-2, 4));
    const Vec3 from = centre + size * far * draw.direction();
    Vec3 target = centre + size * draw.point();
    const auto pick =
        static_cast<std::size_t>(draw.number() * static_cast<double>(things.spheres.size()));
    const double choice = draw.number();
    if (choice < 0.3) {
        const Triangle& t = things.triangles[pick];
        target = t.corner1 + draw.number() * (t.corner2 - t.corner1);
    } else if (choice < 0.6) {
        const Sphere& s = things.spheres[pick];
        target = s.centre + s.radius * unit(cross(s.centre - from, draw.direction()));
    }
    return {from, std::pow(10, draw.between(-2, 2)) * unit(target - from)};
}

void rule_out_nothing(std::size_t rays) {
    struct Place {
        Vec3 centre;
        double size;
    };
    const Place places[] = {{Vec3(0), 1},      {Vec3(0.3, 5, -2), 0.01}, {Vec3(1e6, -1e6, 1e6), 1},
                            {Vec3(1e6), 1e-5}, {Vec3(0), 1e-12},         {Vec3(3e12), 1e9},
                            {Vec3(0), 1e25},   {Vec3(0), 1e-30}};
    Draw draw(1);
    for (const auto& [centre, size] : places) {
        CAPTURE(size);
        const Things things = scattered(21, centre, size, draw);
        const WideTree tree = packed(things, {centre - Vec3(size), centre + Vec3(size)});
        std::size_t lost = 0, met = 0, wrong = 0;
        for (std::size_t i = 0; i < rays; ++i) {
            const Ray ray = aimed(things, centre, size, draw);
            const double there = length(centre - ray.origin) / length(ray.direction);
            const Interval range{draw.between(-1, 1) * there, draw.between(0.5, 2) * there};
            const Candidates found = candidates(tree, things, ray, range);
            // Rays that miss the leaf test nothing.
            if (!(found.count > 0)) continue;
            bool blocks = false;
            for (std::uint32_t item = 0; item < things.size(); ++item) {
                const bool meets = things.meet(item, ray, range) < range.max;
                met += meets;
                lost += meets && !found.asked[item];
                blocks |= meets;
            }
            wrong += blocked(tree, things, ray, range).blocked != blocks;
        }
        CHECK(lost == 0);
        CHECK(wrong == 0);
        CHECK(met > rays / 10);
    }
}

}  // namespace

TEST_CASE("packs rule out nothing that rays meet", "[shape]") { rule_out_nothing(3000); }

TEST_CASE("packs rule out nothing that millions of rays meet", "[.long]") {
    rule_out_nothing(300'000);
}

TEST_CASE("tiny spheres far apart are met from far away", "[shape]") {
    // The entry point into a leaf is less exact than the leaf's size.
    Draw draw(3);
    for (const double radius : {1e-8, 1e-10, 1e-12}) {
        CAPTURE(radius);
        Things things;
        for (int place = 0; place < 6; ++place) {
            const Vec3 centre = draw.point();
            for (int i = 0; i < 3; ++i)
                things.spheres.push_back({centre + 3 * radius * draw.point(), radius});
        }
        const auto box = [&](std::uint32_t i) {
            const Sphere& s = things.spheres[i];
            return Box{s.centre - Vec3(s.radius), s.centre + Vec3(s.radius)};
        };
        WideTree tree = build_tree(static_cast<std::uint32_t>(things.size()), box, ItemPart(),
                                   TreeSettings(), 1);
        tree.pack(leaf_packs(things.kinds()), 1);
        std::size_t met = 0, lost = 0;
        for (int i = 0; i < 30000; ++i) {
            const Sphere& aim = things.spheres[static_cast<std::size_t>(i) % things.size()];
            const Vec3 from = aim.centre + 60.0 * draw.direction();
            const Ray ray{from, unit(aim.centre + 0.9 * radius * draw.point() - from)};
            const Candidates found = candidates(tree, things, ray, {});
            for (std::uint32_t item = 0; item < things.size(); ++item) {
                const bool meets = things.meet(item, ray, {}) < Interval{}.max;
                met += meets;
                lost += meets && !found.asked[item];
            }
        }
        CHECK(met > 20000);
        CHECK(lost == 0);
    }
}

TEST_CASE("packs leave little in doubt", "[shape]") {
    Draw draw(2);
    for (const Vec3& centre : {Vec3(0), Vec3(1e6)}) {
        Things things, round;
        const Box around{centre - Vec3(1.2), centre + Vec3(1.2)};
        // Full leaves, each of one kind.
        for (int i = 0; i < 128; ++i) {
            const Vec3 place = centre + draw.point();
            things.spheres.push_back({place, 0.1});
            things.triangles.push_back({place + 0.1 * draw.point(), place + 0.1 * draw.point(),
                                        place + 0.1 * draw.point()});
        }
        round = things;
        for (const Sphere& s : things.spheres)
            things.boxes.insert(things.boxes.end(), 2,
                                {s.centre - Vec3(0.1), s.centre + Vec3(0.1)});
        const WideTree tree = packed(things, around), round_tree = packed(round, around);
        std::size_t asked = 0, met = 0, doubtful = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 from = centre + 3.0 * draw.direction();
            const Ray ray{from, unit(centre + 0.5 * draw.point() - from)};
            const Interval range{0, draw.between(1, 5)};
            asked += candidates(tree, things, ray, range).count;
            doubtful += blocked(round_tree, round, ray, range).asked;
            for (std::uint32_t item = 0; item < things.size(); ++item)
                met += things.meet(item, ray, range) < range.max;
        }
        CHECK(met > 1000);
        CHECK(asked < 11 * met / 10);
        CHECK(doubtful < 100);
    }
}

TEST_CASE("of few boxes, and by a ray without a direction, all are asked", "[shape]") {
    Things things;
    const Box around{Vec3(-1), Vec3(1)};
    things.spheres = {{Vec3(50), 0.1}, {Vec3(0), 0.1}};
    const Box there{Vec3(-0.5), Vec3(0.5)}, beside{Vec3(0.6), Vec3(0.9)};
    things.boxes = {beside, there};
    const Ray ray{Vec3(-5, 0, 0), Vec3(1, 0, 0)};
    CHECK(candidates(packed(things, around), things, ray, {}).asked ==
          std::vector<bool>{false, true, true, true});
    things.boxes = {beside, there, beside};
    CHECK(candidates(packed(things, around), things, ray, {}).asked ==
          std::vector<bool>{false, true, false, true, false});
    const Ray nowhere{Vec3(0), Vec3(0)};
    PackRay still(nowhere);
    std::size_t asked = 0;
    packed(things, around).traverse(ray, {}, [&](const TreeLeaf& leaf, const Interval& range) {
        return still.candidates(leaf, range, [&](std::uint32_t) { return ++asked == 5; });
    });
    CHECK(asked == 5);
}

TEST_CASE("without packs everything is asked", "[shape]") {
    const WideTree tree = build_tree(std::vector<Box>(3, Box{Vec3(-1), Vec3(1)}));
    const Ray ray{Vec3(-5, 0, 0), Vec3(1, 0, 0)};
    std::size_t asked = 0;
    PackRay packed(ray);
    tree.traverse(ray, {}, [&](const TreeLeaf& leaf, const Interval& range) {
        return packed.candidates(leaf, range, [&](std::uint32_t) { return ++asked, false; });
    });
    CHECK(asked == 3);
}

}  // namespace candelabra
