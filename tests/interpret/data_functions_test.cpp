// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/data_functions.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::map<std::string, std::string> data_files = {
    {"leds.csv", "name,x,y,z,tint\nleft,-1,0,0.5,#ff0000\nright,2,0,1,#fff\n"},
    {"numbers.csv", "1;2\n3,5;\n"},
    {"short.csv", "x,y\n1,2\n\n3\n"},
    {"dots.csv", "pos.x,pos.y\n1,2\n"},
    {"empty.csv", ""},
    {"scene.json", R"({"title": "tree", "lamps": [{"at": [1, 2, 3], "on": true},
                        {"at": [4, 5, 6], "on": false}], "none": null})"},
    {"list.json", "[5, 6]"},
    {"broken.json", "{\n  \"a\": ,\n}"},
};

/// The output of the script, followed by the first line of each message.
std::string told(const std::string& script, const Limits& limits = {}) {
    std::string text;
    EvaluateOptions options;
    options.limits = limits;
    options.print = [&](std::string_view said) { text += said; };
    const Script done =
        run("#version 3.7;\n#macro P(A) #debug str(A, 0, 1) #debug \" \" #end\n" + script,
            data_files, options);
    for (const Diagnostic& each : done.said) text += "! " + each.message;
    return text;
}

}  // namespace

TEST_CASE("a table is asked by row, and by column or name", "[csv]") {
    CHECK(told(R"x(#declare A = read_csv("leds.csv");
        P(dimension_size(A, 1)) P(dimension_size(A, 2)) P(A[1][1]) P(A[0]["z"])
        #for (I, 0, 1) #debug A[I]["name"] #debug " " #end
        #declare C = A[0]["tint"]; P(C.red) P(C.green) #declare C = A[1][4]; P(C.blue))x") ==
          "2.0 5.0 2.0 0.5 left right 1.0 0.0 1.0 ");
    CHECK(told(R"x(#declare N = column_names(read_csv("leds.csv"));
        #declare A = read_csv("leds.csv"); #debug N[3] P((A[1][3] = A[1][N[3]])))x") == "z1.0 ");
    CHECK(told(R"x(#declare A = read_csv("numbers.csv"); P(A[1][0])
        #ifdef (A[1][1]) P(9) #end #ifdef (A[0][1]) P(A[0][1]) #end)x") == "3.5 2.0 ");
    CHECK(told(R"x(#declare A = read_csv("dots.csv"); P(A[0]["pos.y"]))x") == "2.0 ");
    CHECK(told(R"x(#declare A = read_csv("leds.csv"); #declare A[0]["x"] = 7; P(A[0]["x"]))x") ==
          "7.0 ");
    CHECK(told(R"x(#declare A = read_csv("leds.csv");
        #macro Twice(V) (2*V) #end P(Twice(A[1]["x"])))x") == "4.0 ");
}

TEST_CASE("a column is found by its name", "[csv]") {
    CHECK(told(R"x(#declare A = read_csv("leds.csv");
        P(find_column(A, "z")) P(find_column(A, "Z")) P(find_column(A, "q"))
        P(find_column(read_csv("numbers.csv"), "x")))x") == "3.0 3.0 -1.0 -1.0 ");
}

TEST_CASE("what is wrong with a table names its line", "[csv]") {
    CHECK(told(R"x(#declare A = read_csv("short.csv");)x") ==
          "! line 4 of `short.csv` has 1 cell, and the header has 2");
    CHECK(told(R"x(#declare A = read_csv("empty.csv");)x") == "! `empty.csv` is empty");
    CHECK(told(R"x(#declare A = read_csv("gone.csv");)x").find("gone.csv") != std::string::npos);
    CHECK(told(R"x(#declare A = read_csv("leds.csv", "no_heder");)x") ==
          "! `no_heder` is no option of read_csv; there are header, no_header, text, comma, "
          "semicolon, tab, bar and blank");
    CHECK(told(R"x(#declare A = read_csv("leds.csv"); P(A[0]["zz"]))x") ==
          "! there is nothing called `zz` here");
    CHECK(told(R"x(#declare A = read_csv("numbers.csv"); P(A[0]["x"]))x") ==
          "! this index must be a number: nothing here has a name");
    CHECK(told(R"x(#declare A = read_csv("leds.csv"); P(A["x"][0]))x") ==
          "! this index must be a number: nothing here has a name");
    CHECK(
        told(R"x(#declare N = column_names(read_csv("numbers.csv")); P(dimension_size(N, 1)))x") ==
        "0.0 ");
}

TEST_CASE("tables and JSON keep to the limits", "[csv]") {
    Limits few;
    few.array_elements = 9;
    CHECK(told(R"x(#declare A = read_csv("leds.csv");)x", few) ==
          "! `leds.csv` has more than 9 cells, which is the limit of an array");
    CHECK(told(R"x(#declare A = read_json("scene.json");)x", few) ==
          "! `scene.json` has more than 9 values, which is the limit");
    few = {};
    few.files = 3;
    CHECK(told(R"x(#for (I, 1, 9) #declare A = read_csv("leds.csv"); #end)x", few) ==
          "! this scene includes or opens files more than 3 times, which is the limit");
    few = {};
    few.work = 200'000;
    CHECK(told(R"x(#while (1) #declare A = read_csv("leds.csv"); #end)x", few)
              .find("steps before it is rendered") != std::string::npos);
}

TEST_CASE("JSON is asked by paths", "[json]") {
    CHECK(told(R"x(#declare J = read_json("scene.json"); #debug J["title"]
        P(J["lamps.1.at.2"]) P(J["lamps"][0]["on"]) P(J["lamps"][0]["at.1"])
        P(dimension_size(J["lamps"], 1)))x") == "tree6.0 1.0 2.0 2.0 ");
    CHECK(told(R"x(P(read_json("scene.json", "lamps.1.at.0")) P(read_json("list.json", "1")))x") ==
          "4.0 6.0 ");
    CHECK(told(R"x(#declare J = read_json("scene.json");
        #ifdef (J["none"]) P(1) #end #ifdef (J["lamps.0.off"]) P(2) #end
        #ifdef (J["gone"]) P(3) #end #ifdef (J["none.x"]) P(4) #end
        #ifdef (J["title.x"]) P(6) #end #ifdef (J["lamps.0.on.x"]) P(7) #end
        #ifdef (J["lamps.0.on"]) P(5) #end)x") == "5.0 ");
    CHECK(told(R"x(P(read_json("scene.json", "lamps.0.onn")))x") ==
          "! there is nothing called `onn` here");
    CHECK(told(R"x(P(read_json("scene.json", "lamps.2.on")))x") ==
          "! the index must be from 0 to 1, but it is 2");
    CHECK(told(R"x(P(read_json("scene.json", "none")))x") ==
          "! `scene.json` has null or nothing in this place");
    CHECK(told(R"x(#declare J = read_json("broken.json");)x") ==
          "! line 2 of `broken.json` is no JSON from here on");
}

TEST_CASE("a scene may use the names of these functions", "[csv]") {
    CHECK(told("#declare read_csv = 3; P(read_csv) #macro column_names(A) (A+1) #end "
               "P(column_names(1))") == "3.0 2.0 ");
}

}  // namespace candelabra
