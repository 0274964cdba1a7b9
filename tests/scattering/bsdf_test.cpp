// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/bsdf.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

using std::numbers::pi;

struct Look {
    Finish finish;
    Shading shading;

    explicit Look(const Finish& f, const Vec3& view = unit(Vec3(1, -1, 0.3))) : finish(f) {
        shading.view = view;
        shading.normal = shading.geometric_normal = Vec3(0, 1, 0);
        shading.finish = &finish;
        shading.colour = {Rgb(0.5)};
    }
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
};

Finish highlights(double diffuse, double phong, double phong_size, double specular,
                  double roughness) {
    Finish result;
    result.diffuse = diffuse;
    result.phong = phong;
    result.phong_size = phong_size;
    result.specular = specular;
    result.roughness = roughness;
    return result;
}

Finish facets(double roughness, double metallic, double coat = 0) {
    Finish result;
    result.microfacet.on = true;
    result.microfacet.roughness = roughness;
    result.microfacet.metallic = metallic;
    result.microfacet.coat = coat;
    result.microfacet.coat_roughness = 0.5;
    return result;
}

const std::vector<Finish>& looks() {
    static const std::vector<Finish> all = {highlights(0.6, 0, 40, 0, 0.05),
                                            highlights(0.6, 0.8, 40, 0, 0.05),
                                            highlights(0, 0, 40, 0.7, 0.1),
                                            highlights(0.3, 0.4, 5, 0.9, 0.04),
                                            facets(0.4, 1),
                                            facets(0.6, 0),
                                            facets(0.5, 0.3, 1),
                                            facets(0.1, 1)};
    return all;
}

/// Bin of a direction: 8 by height, 16 around.
std::size_t bin(const Vec3& d) {
    const auto row = std::min<std::size_t>(static_cast<std::size_t>((d.y + 1) * 4), 7),
               column = static_cast<std::size_t>((std::atan2(d.z, d.x) / pi + 1) * 8) % 16;
    return row * 16 + column;
}

/// Every kind of finish, by itself and together with others.
std::vector<std::pair<std::string, Finish>> kinds() {
    std::vector<std::pair<std::string, Finish>> all;
    const auto add = [&](const std::string& name, Finish finish, auto... change) {
        (change(finish), ...);
        all.emplace_back(name, finish);
    };
    const auto back = [](double amount) { return [=](Finish& f) { f.diffuse_back = amount; }; };
    add("diffuse", highlights(0.6, 0, 40, 0, 0.05));
    add("diffuse a, b", highlights(0.4, 0, 40, 0, 0.05), back(0.4));
    add("mostly b", highlights(0.1, 0, 40, 0, 0.05), back(0.7));
    add("only b", highlights(0, 0, 40, 0, 0.05), back(0.7));
    add("negative b", highlights(0.5, 0, 40, 0, 0.05), back(-0.2));
    add("brilliance", highlights(0.6, 0, 40, 0, 0.05), [](Finish& f) { f.brilliance = 3; });
    add("brilliance below 1 and b", highlights(0.6, 0, 40, 0, 0.05), back(0.2),
        [](Finish& f) { f.brilliance = 0.5; });
    add("crand", highlights(0.6, 0, 40, 0, 0.05), [](Finish& f) { f.crand = 0.1; });
    add("irid", highlights(0.6, 0.4, 20, 0, 0.05), [](Finish& f) {
        f.irid.amount = 0.3;
        f.irid.thickness = 0.5;
    });
    add("phong", highlights(0.6, 0.8, 40, 0, 0.05));
    add("phong alone", highlights(0, 0.8, 20, 0, 0.05));
    add("phong and b", highlights(0, 0.8, 20, 0, 0.05), back(0.5));
    add("wide phong", highlights(0.3, 0.8, 1, 0, 0.05));
    add("specular alone", highlights(0, 0, 40, 0.7, 0.1));
    add("specular and b", highlights(0.2, 0, 40, 0.7, 0.1), back(0.5));
    add("phong and specular", highlights(0.3, 0.4, 5, 0.9, 0.04));
    add("metallic", highlights(0.3, 0.4, 5, 0.9, 0.1), [](Finish& f) { f.metallic = 1; });
    add("rough metal", facets(0.6, 1));
    add("rougher metal", facets(1, 1));
    add("rough dielectric", facets(0.6, 0));
    add("smooth dielectric", facets(0.1, 0));
    add("coat", facets(0.5, 0.3, 1));
    add("smooth metal", facets(0.1, 1));
    add("brushed metal", facets(0.15, 1));
    add("facets and b", facets(0.5, 0), back(0.5));
    return all;
}

struct Place {
    bool both_sides;
    Vec3 view;
    Vec3 normal;
};

/// Surfaces lit from one side or from both, seen from above and grazing, with the normal of the
/// real surface, bent, and turned to the viewer.
std::vector<Place> bench_places() {
    std::vector<Place> all;
    for (const bool both : {false, true})
        for (const Vec3& view : {unit(Vec3(1, -1, 0.3)), unit(Vec3(-1, -0.1, 0.5))})
            for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0.5, 1, 0.2), Vec3(-1, 0.4, 0.1)})
                all.push_back({both, view, unit(normal)});
    return all;
}

/// The centre of a cell of a grid whose cells have equal solid angles.
Vec3 direction_in(int rows, int columns, int i, int j) {
    const double y = 2 * (i + 0.5) / rows - 1, turn = 2 * pi * (j + 0.5) / columns;
    const double across = std::sqrt(1 - y * y);
    return Vec3(across * std::cos(turn), y, across * std::sin(turn));
}

/// Calls use(i, j, centre, solid angle) for the cells of a grid of directions.
template <class Use>
void over_cells(int rows, int columns, const Use& use) {
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            use(i, j, direction_in(rows, columns, i, j), 4 * pi / (rows * columns));
}

template <class Use>
void over_directions(int rows, int columns, const Use& use) {
    over_cells(rows, columns, [&](int, int, const Vec3& centre, double solid_angle) {
        use(centre, solid_angle);
    });
}

/// Probabilities of the bins, integrated over a grid, which is finer where a lobe is narrow.
std::vector<double> said_by(const Bsdf& bsdf) {
    constexpr int rows = 120, columns = 240, finer = 16;
    std::vector<double> said(128, 0);
    over_cells(rows, columns, [&](int i, int j, const Vec3& centre, double solid_angle) {
        const double density = bsdf.pdf(centre);
        if (density < 1) {
            said[bin(centre)] += density * solid_angle;
            return;
        }
        for (int k = 0; k < finer * finer; ++k) {
            const Vec3 d = direction_in(rows * finer, columns * finer, i * finer + k / finer,
                                        j * finer + k % finer);
            said[bin(d)] += bsdf.pdf(d) * solid_angle / (finer * finer);
        }
    });
    return said;
}

/// Calls use(bsdf) for every kind of finish at every place, and for light that enters a solid.
template <class Use>
void for_bsdfs(const Use& use) {
    for (const auto& [name, finish] : kinds())
        for (const auto& [both, view, normal] : bench_places()) {
            Look look(finish, view);
            look.shading.both_sides = both;
            look.shading.normal = normal;
            CAPTURE(name, both, view.x, normal.x);
            use(Bsdf(look.shading, ShadingRules()));
            use(Bsdf::highlights_of(look.shading, ShadingRules()));
            if (name == "diffuse") use(Bsdf::entering(look.shading, ShadingRules(), 1.5));
        }
}

}  // namespace

TEST_CASE("each direction from which light counts can be drawn", "[scattering]") {
    Draw draw(4);
    for_bsdfs([&](const Bsdf& bsdf) {
        for (int i = 0; i < 500; ++i) {
            const Vec3 d = draw.direction();
            if (bsdf.evaluate(d, {.facets = FacetLobes::wide}, 0.5) == Rgb(0)) continue;
            CAPTURE(d.x, d.y, d.z);
            CHECK(bsdf.pdf(d) > 0);
        }
    });
}

TEST_CASE("no light comes through the real surface", "[scattering]") {
    Draw draw(5);
    for_bsdfs([&](const Bsdf& bsdf) {
        const Shading& s = bsdf.shading();
        const bool behind = s.both_sides || s.finish->diffuse_back != 0;
        for (int i = 0; i < 200; ++i) {
            const Vec3 d = draw.direction();
            const double real = d.y, shown = dot(d, s.normal);
            if (s.finish->microfacet.on ? real > 0 : real * shown > 0 && (behind || real > 0))
                continue;
            CAPTURE(d.x, d.y, d.z);
            CHECK(bsdf.evaluate(d, {}, 0.5) == Rgb(0));
            CHECK(bsdf.pdf(d) == 0);
        }
    });
}

TEST_CASE("light of POV-Ray's sources may come through the real surface", "[scattering]") {
    Look look(highlights(0.6, 0, 40, 0, 0.05), unit(Vec3(-1, -1, 0)));
    look.shading.normal = unit(Vec3(1, 0.5, 0));
    const Vec3 below = unit(Vec3(1, -0.2, 0));
    const Bsdf bsdf(look.shading, ShadingRules());
    CHECK(bsdf.evaluate(below, {}, 0) == Rgb(0));
    CHECK(bsdf.evaluate(below, {.through_surface = true}, 0).r > 0.1);
}

TEST_CASE("directions are drawn with the density that is said", "[render]") {
    std::uint64_t seed = 0;
    for_bsdfs([&](const Bsdf& bsdf) {
        const std::vector<double> said = said_by(bsdf);
        std::vector<double> drawn(said.size(), 0);
        constexpr int count = 10000;
        Draw draw(++seed);
        for (int i = 0; i < count; ++i)
            if (const auto d = bsdf.sample({draw.number(), draw.number()}))
                drawn[bin(*d)] += 1.0 / count;
        // The grid's error is about a thousandth of a bin's share, and of all directions.
        double squares = 0, all = 0, kept = 0;
        for (std::size_t b = 0; b < said.size(); ++b) {
            const double apart = drawn[b] - said[b];
            squares += apart * apart / (said[b] / count + 1e-6);
            all += said[b], kept += drawn[b];
        }
        const double bins = static_cast<double>(said.size());
        CHECK(squares < bins + 5 * std::sqrt(2 * bins));
        CHECK(all < 1.002);
        CHECK(kept == Approx(all).margin(0.002 + 5 * std::sqrt(0.25 / count)));
        // All directions count where the normal is that of the real surface.
        const Shading& s = bsdf.shading();
        if (s.normal == s.geometric_normal && bsdf.specular_probability() == 0)
            CHECK(all == Approx(1).margin(0.002));
    });
}

TEST_CASE("a finish sends on no more light than it claims, at any elevation", "[scattering]") {
    for (const auto& [name, finish] : kinds())
        for (const double height : {1.0, 0.6, 0.3, 0.1, 0.02}) {
            Look look(finish, unit(Vec3(std::sqrt(1 - height * height), -height, 0)));
            look.shading.colour = {Rgb(1)};
            const Bsdf bsdf(look.shading, ShadingRules());
            CAPTURE(name, height);
            const double claimed = bsdf.diffuse_albedo().r + bsdf.facets_albedo().r;
            const bool shines = finish.phong > 0 || finish.specular > 0;
            if (shines) continue;  // as in POV-Ray, highlights are added to all light
            CHECK(claimed <= 1 + 1e-9);
            if (finish.microfacet.on) CHECK(claimed > 0.97);
            // Lobes that a grid cannot integrate are those that scattered rays sample.
            if (finish.microfacet.on && finish.microfacet.roughness < 0.4) continue;
            double sum = 0;
            over_directions(400, 400, [&](const Vec3& d, double solid_angle) {
                sum += bsdf.evaluate(d, {}, 0.5).r * solid_angle / pi;
            });
            if (finish.brilliance == 1 && finish.crand == 0 && finish.irid.amount == 0 &&
                finish.diffuse_back >= 0)
                CHECK(sum == Approx(claimed).epsilon(0.02));
            if (finish.brilliance >= 1) CHECK(sum < 1.02);
        }
}

TEST_CASE("light takes the same way back", "[scattering]") {
    // POV-Ray's highlights and brilliance do not, nor its crand and thin films.
    Draw draw(6);
    for (const auto& [name, finish] : kinds()) {
        if (finish.phong > 0 || finish.specular > 0 || finish.brilliance != 1 || finish.crand > 0 ||
            finish.irid.amount > 0)
            continue;
        for (int i = 0; i < 200; ++i) {
            Vec3 there = draw.direction(), back = draw.direction();
            there.y = 0.02 + std::abs(there.y);
            back.y = 0.02 + std::abs(back.y);
            there = unit(there), back = unit(back);
            const Look from(finish, -back), to(finish, -there);
            CAPTURE(name, there.x, there.y, back.x, back.y);
            const Rgb one = Bsdf(from.shading, ShadingRules()).evaluate(there, {}, 0) / there.y,
                      other = Bsdf(to.shading, ShadingRules()).evaluate(back, {}, 0) / back.y;
            for (int c = 0; c < 3; ++c) CHECK(one[c] == Approx(other[c]).epsilon(1e-9));
        }
    }
}

TEST_CASE("surfaces without highlights, or that leave them to reflection, draw none", "[render]") {
    const Look dull(looks().front()), mirror(facets(0.05, 1)), shiny(highlights(0, 1, 40, 0, 0.05));
    CHECK(Bsdf(dull.shading, ShadingRules()).specular_probability() == 0);
    CHECK(Bsdf(mirror.shading, ShadingRules()).specular_probability() == 0);
    CHECK(Bsdf(shiny.shading, ShadingRules()).specular_probability() > 0.5);
}

TEST_CASE("what the choice of luminaires knows of highlights is near what they answer",
          "[render]") {
    for (const Finish& finish : looks()) {
        const Look look(finish);
        const Bsdf bsdf(look.shading, ShadingRules());
        const BsdfLobes known = bsdf.lobes();
        const Vec3 mirrored(look.shading.view.x, -look.shading.view.y, look.shading.view.z);
        Draw draw(2);
        for (int i = 0; known.count > 0 && i < 50; ++i) {
            const Vec3 d = unit(mirrored + 0.3 * draw.between(0, 1) * draw.direction());
            if (d.y < 0.1) continue;
            double sum = known.diffuse * d.y;
            for (std::size_t k = 0; k < known.count; ++k) sum += known.highlights[k].reflected(d);
            const double answer = bsdf.evaluate(d, {.facets = FacetLobes::wide}, 0).r;
            CAPTURE(finish.phong, finish.specular, finish.microfacet.roughness, d.x, d.y, d.z);
            CHECK(sum > 0.3 * answer);
            CHECK(sum < 5 * answer + 0.05);
        }
    }
}

TEST_CASE("a highlight of a flat view is as narrow across as it is answered", "[render]") {
    const double low = 0.1;
    for (const double roughness : {0.2, 0.3, 0.4}) {
        const Look look(facets(roughness, 1), unit(Vec3(1, -low, 0)));
        const Bsdf bsdf(look.shading, ShadingRules());
        const BsdfLobes known = bsdf.lobes();
        REQUIRE(known.count == 1);
        const auto ratio = [&](double up, double across) {
            const Vec3 d = unit(Vec3(1, low + up, across));
            const double answer = bsdf.evaluate(d, {.facets = FacetLobes::wide}, 0).r;
            return (known.diffuse * d.y + known.highlights[0].reflected(d)) / answer;
        };
        const double straight = ratio(0, 0);
        CAPTURE(roughness, straight);
        for (const double across : {0.01, 0.03, 0.1})
            CHECK(ratio(0, across) == Approx(straight).epsilon(0.3));
        for (const double up : {0.01, 0.03, 0.1})
            CHECK(ratio(up, 0) == Approx(straight).epsilon(0.6));
    }
}

}  // namespace candelabra
