// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/share_show.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("share makes a page of kept light that plays a show", "[app][relight]") {
    Shell run;
    run.write("many.pov",
              std::string(lit_scene) +
                  "union { #for (I, 0, 49) sphere { <I/10 - 2.5, 0.5, 0>, 0.03 pigment { rgb 1 } "
                  "finish { ambient 0 diffuse 0 emission 9 } } #end light_name \"Row\" }");
    REQUIRE(run({run.path("many.pov"), "-V", "+W64", "+H48", "--samples", "8", "--keep-lights",
                 run.path("many.lights"), "+O" + run.path("many.png")}) == 0);
    run.write("show.csv", "Row,Row[3]\n1,0\n0.5,#ff0000\n");
    REQUIRE(run({"share", run.path("many.lights"), "--csv", run.path("show.csv"), "-o",
                 run.path("page.html")}) == 0);
    CHECK(has(run.err, "2 lamps"));
    const std::string page = run.content("page.html");
    CHECK(has(page, "\"frames\":2"));
    CHECK(has(page, "\"grey\":false"));
    CHECK(has(page, "\"groups\":[1,50]"));
    REQUIRE(run({"share", run.path("many.lights"), "--csv", run.path("show.csv"), "-o",
                 run.path("again.html"), "+WT2"}) == 0);
    const std::string again = run.content("again.html");
    const std::size_t show = page.find("id=\"show-data\"");
    CHECK(again.substr(again.find("id=\"show-data\"")) == page.substr(show));
    // One picture that is no show.
    REQUIRE(run({"share", run.path("many.lights"), "--set", "Row=0.5"}) == 0);
    CHECK(has(run.content("many.html"), "\"frames\":1"));
    const auto refused = [&](std::vector<std::string> words, int status, std::string_view why) {
        INFO(why);
        words.insert(words.begin(), "share");
        CHECK(run(words) == status);
        CHECK(has(run.err, why));
    };
    refused({run.path("many.pov"), "--csv", run.path("show.csv")}, 2, "a show needs the light");
    refused({run.path("many.lights"), run.path("many.pov")}, 2, "a page has one picture");
    refused({run.path("many.lights"), "--csv", run.path("none.csv")}, 3, "none.csv");
    refused({run.path("many.lights"), "--set", "Raw=1"}, 3, "there is no lamp `Raw`");
    refused({run.path("none.lights")}, 3, "cannot be read");
}

}  // namespace candelabra
