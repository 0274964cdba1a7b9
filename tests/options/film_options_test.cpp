// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/film_options.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct FilmRead {
    std::vector<FilmChange> changes;
    std::string wrong;
};

FilmRead film_read(std::vector<std::string_view> arguments) {
    Diagnostics diagnostics;
    arguments.push_back("a.pov");
    FilmRead result{read_options(arguments, diagnostics).render.film, {}};
    if (!diagnostics.all().empty()) result.wrong = diagnostics.all().front().message;
    return result;
}

}  // namespace

TEST_CASE("options change the film, one after the other", "[app][film]") {
    const FilmRead read =
        film_read({"--film", "on", "--exposure", "auto-1", "--white-balance=3200", "--response",
                   "agx", "--pixel-filter", "mitchell", "--smooth-edges", "off", "--glare",
                   "veil=0.2,blades=5", "--vignette", "0.3", "--grain", "0.02", "--glare", "off"});
    CHECK(read.wrong.empty());
    CHECK(read.changes == std::vector<FilmChange>{{"film", "on"},
                                                  {"exposure", "auto-1"},
                                                  {"white_balance", "3200"},
                                                  {"response", "agx"},
                                                  {"pixel_filter", "mitchell"},
                                                  {"smooth_edges", "off"},
                                                  {"glare.veil", "0.2"},
                                                  {"glare.blades", "5"},
                                                  {"vignette", "0.3"},
                                                  {"grain", "0.02"},
                                                  {"glare", "off"}});
}

TEST_CASE("wrong options of a film are refused", "[app][film]") {
    CHECK(film_read({"--response", "kodak"}).wrong ==
          "`--response`: there is no response of a film `kodak`, but `linear`, `filmic` or `agx`");
    CHECK(film_read({"--exposure", "bright"}).wrong ==
          "`--exposure`: exposure must be a number from -40 to 40");
    CHECK(film_read({"--glare", "much"}).wrong ==
          "`--glare`: glare is on, off, or fields with their values and commas between");
    CHECK(film_read({"--glare", "glow=1"}).wrong == "`--glare`: a film has no `glare.glow`");
    CHECK(film_read({"--vignette=2"}).wrong ==
          "`--vignette=2`: vignette must be a number from 0 to 1");
    CHECK(film_read({"--film", "5"}).wrong == "`--film`: film must be `on` or `off`");
}

}  // namespace candelabra
