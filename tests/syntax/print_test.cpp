// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/print.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("printed text parses to the same tree", "[syntax]") {
    const std::string text = GENERATE(
        as<std::string>(), "", "1, -2, <1, 2>, a [1]",
        "sphere { <0, 1, 2>, 3 pigment { rgb <1, 0, 0> } no_shadow rotate -30 * y }",
        "#declare A[1][2] = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } };",
        "#local S = \"a\\\"b\\\\c\\n\";", "#declare deprecated once \"old\" a = 1;",
        "#declare (a, b) = (1, 2);", "#undef a #undef A[1]",
        "#if (a < 1 & b) 1 #elseif (c) 2 #else 3 #end", "#ifdef (a) 1 #end #ifndef (A[1]) 2 #end",
        "#while (a ? b : !c) #break #end", "#for (i, 1, 10, 2) box { i, i } #end",
        "#switch (a) 0 #case (1) 1 #range (2, 3) 2 #else 3 #end",
        "#macro M(a, optional b) a + b #end M(1, A[2])",
        "#include \"a.inc\" #include concat(\"a\", b)", "#default { finish { ambient 0 } }",
        "#debug \"x\" #warning s #error str(1, 0, 0)", "#version 3.7; #version unofficial 3.6;",
        "#fopen F \"a.txt\" write #write (F, 1, \"a\", <1, 2>) #read (F, a, b) #fclose F",
        "rgb 1 filter .5, color Red, color red 1 blue 2, color rgb 1, Red filter .5, filter, 1",
        "color_map { [0 rgb 1] [1, Red transmit 1] }",
        "function (x, y) { x + y < 2 } function { pattern { marble } } function 10, 20 { x }",
        "#declare T = texture { A } texture { B };",
        "light_sampler { linear_alpha { threshold 1 } }", "<a, 1 + 2, (b > 1)>",
        "(#declare b = 1; b)", "#declare a = #local b = 2; #local c = b; sphere { 0, c }",
        "#declare a = #local b = 2; 1 + b; #local c = #local d = 2; color rgb d filter 1;",
        "#macro M(a) union { sphere { 0, a } #end #declare b = M(1.5) } M(b) }",
        "1 + 2 #if (a) * 3 #elseif (b) #local c = 1; - c * 2 #if (d) / 4 #end #end - 5, 6",
        "<1, #for (i, 1, 2) i, #end 2 #while (a) + 1 #end>", "vrotate(x, <0, 90, 0>).y * M()",
        "text { ttf \"a.ttf\" \"b\" 1, 0 }", "a precision \"b\\p\"", "#include \"a\\b.inc\"",
        "#include \"a\nb\"", "0.. false, 1..x", "#version 3.green, ere { 0, as \"up\" }",
        "3.x, rgb, a { 1 }, 5.green",
        "filter, #if (a) 1 #end rgb, #declare a = 1; transmit, [1 2] red, {}");
    INFO(text);
    const Parsed first(text);
    REQUIRE(first.messages() == "");
    const std::string printed = print(first.tree, first.names);
    INFO(printed);
    const Parsed second(printed);
    CHECK(second.messages() == "");
    CHECK(second.dumped() == first.dumped());
    CHECK(print(second.tree, second.names) == printed);
}

TEST_CASE("a tree prints in this layout", "[syntax]") {
    const Parsed parsed("#if(a)sphere{0,1 pigment{rgb 1}}#end");
    CHECK(print(parsed.tree, parsed.names) ==
          "#if (a)\n"
          "    sphere {\n"
          "        0,\n"
          "        1\n"
          "        pigment {\n"
          "            rgb 1\n"
          "        }\n"
          "    }\n"
          "#end\n");
}

}  // namespace candelabra
