// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/film_images.h"

#include "film/film.h"
#include "output/layers.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

const std::vector<std::string> little = {"--samples", "4", "+W40", "+H30", "-V"};

std::vector<std::string> with(std::vector<std::string> more) {
    more.insert(more.end(), little.begin(), little.end());
    return more;
}

}  // namespace

TEST_CASE("rows that a film does not keep to are clear and black", "[output][film]") {
    Film film(3, 6, 1);
    film.keep_to_rows(2, 4);
    film.at(1, 2).add(Rgb(1, 2, 3));
    film.extra(film.index(1, 2))[0].add(0.25);
    std::vector<Rgb> pixels(3, Rgb(9));
    std::vector<double> alpha(3, 9);
    film_row(film, 1, pixels, alpha);
    CHECK(pixels == std::vector<Rgb>(3, Rgb(0)));
    CHECK(alpha == std::vector<double>(3, 0));
    film_row(film, 2, pixels, alpha);
    CHECK(pixels == std::vector<Rgb>{Rgb(0), Rgb(1, 2, 3), Rgb(0)});
    CHECK(alpha == std::vector<double>{0, 0.75, 0});
    film_row(film, 2, pixels, {});
    CHECK(pixels[1] == film.image().at(1, 2));
}

TEST_CASE("compressed samples make a smooth picture", "[output][film]") {
    FilmFiles files;
    files.film.on = true;
    files.film.response = "agx";
    Film film(1, 1, files.aovs().count(std::size_t{0}));
    REQUIRE(film.aovs() == 3);
    for (const double light : {1000.0, 0.0}) {
        const Rgb sample = compressed(Rgb(light), 1);
        film.at(0, 0).add(Rgb(light));
        for (int c = 0; c < 3; ++c) film.extra(0)[static_cast<std::size_t>(c)].add(sample[c]);
    }
    CHECK(smooth_image(film, files).at(0, 0).r == Approx(1).epsilon(0.01));
    CHECK(negative_of(film, files).light.at(0, 0).r == Approx(500));
}

TEST_CASE("a denoised picture lies beside the exact one, which stays", "[output][denoise]") {
    Shell shell;
    const std::string lit = shell.path("lit.pov");
    REQUIRE(shell(with({lit, "+O" + shell.path("a.png")})) == 0);
    REQUIRE(shell(with({lit, "--denoise", "+O" + shell.path("b.png")})) == 0);
    CHECK(std::filesystem::exists(shell.path("b.denoised.png")));
    CHECK_FALSE(std::filesystem::exists(shell.path("b.layers.exr")));
    CHECK(shell.content("b.denoised.png") != shell.content("b.png"));
    REQUIRE(shell(with({lit, "+O" + shell.path("a.ppm")})) == 0);
    REQUIRE(shell(with({lit, "--denoise", "+O" + shell.path("b.ppm")})) == 0);
    const std::string a = shell.content("a.ppm"), b = shell.content("b.ppm");
    CHECK(a.substr(a.size() - 3600) == b.substr(b.size() - 3600));
}

TEST_CASE("a draft is the denoised picture under a name of its own", "[output][denoise]") {
    Shell shell;
    const std::string lit = shell.path("lit.pov");
    const auto end = [&](const char* name) {
        const std::string all = shell.content(name);
        return all.substr(all.size() - std::min<std::size_t>(all.size(), 3600));
    };
    REQUIRE(shell(with({lit, "--denoise", "+O" + shell.path("a.ppm")})) == 0);
    REQUIRE(shell({lit, "--draft", "+W40", "+H30", "+O" + shell.path("b.ppm")}) == 0);
    CHECK(has(shell.err, "draft: "));
    CHECK_FALSE(std::filesystem::exists(shell.path("b.ppm")));
    CHECK(end("b.draft.ppm") == end("a.denoised.ppm"));
    // The file itself says what it is.
    CHECK(has(shell.content("b.draft.ppm"), "draft="));

    REQUIRE(shell(with({lit, "--draft", "--layers", "lights", "--response", "agx",
                        "+O" + shell.path("c.exr")})) == 0);
    REQUIRE(shell({"develop", shell.path("c.draft.exr"), "-o", shell.path("c.ppm")}) == 0);
    REQUIRE(shell(with({lit, "--denoise", "--response", "agx", "+O" + shell.path("d.ppm")})) == 0);
    CHECK(end("c.ppm") == end("d.denoised.ppm"));
    for (const char* shard : {"1/2", "2/2"})
        REQUIRE(shell(with({lit, "--draft", "--shard", shard, "+O" + shell.path("e.ppm")})) == 0);
    REQUIRE(shell({"merge", "-V", shell.path("e.draft.ppm.1of2.state.exr"),
                   shell.path("e.draft.ppm.2of2.state.exr")}) == 0);
    CHECK(end("e.draft.ppm") == end("a.denoised.ppm"));
}

TEST_CASE("denoising does not depend on shards and threads, and is developed", "[output][denoise]") {
    Shell shell;
    const std::string lit = shell.path("lit.pov");
    REQUIRE(shell(with({lit, "--denoise", "--response", "agx", "--glare", "on", "+WT1",
                        "+O" + shell.path("a.png")})) == 0);
    const std::string whole = shell.content("a.denoised.png");
    REQUIRE(shell(with({lit, "--denoise", "--response", "agx", "--glare", "on", "+WT3",
                        "+O" + shell.path("b.png")})) == 0);
    CHECK(shell.content("b.denoised.png") == whole);
    for (const char* shard : {"1/2", "2/2"})
        REQUIRE(shell(with({lit, "--denoise", "--response", "agx", "--glare", "on", "--shard",
                            shard, "+O" + shell.path("c.png")})) == 0);
    REQUIRE(shell({"merge", "-V", shell.path("c.png.1of2.state.exr"),
                   shell.path("c.png.2of2.state.exr")}) == 0);
    CHECK(shell.content("c.denoised.png") == whole);
    REQUIRE(shell(with({lit, "--denoise", "--response", "agx", "--glare", "on",
                        "+O" + shell.path("d.exr")})) == 0);
    CHECK_FALSE(std::filesystem::exists(shell.path("d.denoised.exr")));
    REQUIRE(shell({"develop", shell.path("d.exr"), "--layer", "denoised", "-o",
                   shell.path("d.png")}) == 0);
    CHECK(shell.content("d.png") == whole);
}

}  // namespace candelabra
