// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/films.h"

#include "scene/dump.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const FilmSettings film_of(const std::string& words) {
    const Script done = run("#version 3.7; camera { location -z film { " + words + " } }");
    INFO(words);
    CHECK(done.text == "");
    const std::string text = dump(done.scene);
    CHECK(dump(run(text).scene) == text);
    return done.scene.film;
}

std::string wrong_film(const std::string& words) {
    return complaint("camera { location -z film { " + words + " } }");
}

}  // namespace

TEST_CASE("a camera has a film", "[bind][film]") {
    CHECK_FALSE(run("#version 3.7; camera { location -z }").scene.film.on);
    CHECK(film_of("").on);
    const FilmSettings film = film_of(
        "exposure -1.5 white_balance 3200 response agx pixel_filter box smooth_edges off "
        "vignette 0.25 grain 0.02 grain_seed 3 "
        "glare { veil 0.3 halo 0 star 0.1 blades 5 angle -12 length 1 field 40 }");
    CHECK(to_text(film) ==
          "film=on exposure=-1.5 white_balance=3200 response=agx smooth_edges=0 vignette=0.25 "
          "grain=0.02 grain_seed=3 glare=on glare.veil=0.3 glare.halo=0 glare.star=0.1 "
          "glare.blades=5 glare.angle=-12 glare.length=1 glare.field=40");
    CHECK(film_of("exposure 1+1").exposure == 2);
    CHECK(film_of("exposure - 1").exposure == -1);
    CHECK(film_of("exposure auto").auto_exposure);
    CHECK(film_of("exposure auto vignette 0.1").auto_exposure);
    CHECK(film_of("exposure -2 auto_exposure").exposure == -2);
    for (const char* const text : {"exposure auto+0.5", "exposure auto + 1/2", "exposure 0.5+auto",
                                   "exposure auto-(1 - 1.5) grain 0.1"}) {
        CHECK(film_of(text).auto_exposure);
        CHECK(film_of(text).exposure == 0.5);
    }
    CHECK(complaint("camera { film { exposure 2*auto } }").starts_with("error wrong-type"));
    CHECK(complaint("camera { location auto film { exposure auto } }").starts_with("error"));
    CHECK(film_of("response \"filmic\"").curve() == ResponseCurve::filmic);
    CHECK(film_of("pixel_filter blackman_harris").filter() == FilterShape::blackman_harris);
    CHECK(film_of("glare { }").glares);
}

TEST_CASE("a film belongs to its camera", "[bind][film]") {
    const Script done =
        run("#version 3.7; #declare C = camera { location -z film { response agx exposure 2 } } "
            "camera { C film { exposure 3 } }");
    CHECK(done.text == "");
    CHECK(to_text(done.scene.film) == "film=on exposure=3 response=agx");
    CHECK(run("#version 3.7; #default { camera { location -z film { response agx } } }")
              .scene.film.curve() == ResponseCurve::agx);
    // Names that a scene declares keep their meaning.
    const Script old =
        run("#version 3.7; #declare exposure = 3; #declare film = 2; "
            "sphere { 0, exposure -1 translate film*x }");
    CHECK(old.text == "");
    CHECK(old.shape<Sphere>().radius == 2);
}

TEST_CASE("words of a block may stand before parentheses", "[bind][film]") {
    CHECK(film_of("exposure (1)").exposure == 1);
    CHECK(film_of("exposure (1+1)*2 grain (0.02)").exposure == 4);
    CHECK(film_of("exposure (-1)+(3)").exposure == 2);
    CHECK(film_of("exposure (<1, 2>).y grain (0.02)/2").grain == 0.01);
    CHECK(film_of("exposure (#if (1) 2 #else 3 #end)").exposure == 2);
    CHECK(film_of("#local A = 3; exposure ((A > 2 ? 5 : 6))").exposure == 5);
    // A macro of that name is called.
    CHECK(film_of("#macro grain(A) exposure A #end grain(2)").exposure == 2);
    CHECK(wrong_film("exposure (1, 2)").starts_with("error wrong-count"));
    CHECK(wrong_film("grained (1)").starts_with("error unknown-name"));
    CHECK(complaint("#declare A = exposure (1);").starts_with("error unknown-name"));
    CHECK(complaint("sphere { 0, exposure (1) }").starts_with("error"));
}

TEST_CASE("what is wrong with a film is said", "[bind][film]") {
    CHECK(wrong_film("response kodak") ==
          "error unknown-name: there is no response of a film `kodak`");
    CHECK(wrong_film("response \"kodak\"") ==
          "error degenerate: there is no response of a film `kodak`, but `linear`, `filmic` or "
          "`agx`");
    CHECK(wrong_film("pixel_filter disc") == "error unknown-name: there is no pixel filter `disc`");
    CHECK(wrong_film("vignette 2") ==
          "error out-of-range: `vignette` of `film` must be from 0 to 1, but it is 2");
    CHECK(wrong_film("white_balance 500") ==
          "error degenerate: a white balance is between 1000 and 15000 kelvins, or 0 for none");
    CHECK(wrong_film("glare { veil 0.8 star 0.5 }") ==
          "error degenerate: the shares of `glare` are more than all light together");
    CHECK(complaint("film { }").find("error") == 0);
}

}  // namespace candelabra
