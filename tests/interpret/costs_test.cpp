// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/evaluate.h"
#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The errors of a scene that lies, with its files, in the folder.
std::string spent(const std::string& script, const Limits& limits, const Folder& folder) {
    const std::string here = folder.path().string();
    SourceStore sources;
    Diagnostics diagnostics;
    FileAccess access({here}, {here});
    Loader loader(scene_reader(access), here, {}, access);
    EvaluateOptions options;
    options.limits = limits;
    evaluate(sources, loader, sources.add(here + "/main.pov", "#version 3.7; " + script), options,
             diagnostics);
    std::string messages;
    for (const Diagnostic& each : diagnostics.all())
        if (each.severity == Severity::error) messages += each.message + " | " + each.help + "\n";
    return messages;
}

std::string spent(const std::string& script, const Limits& limits = {}) {
    return spent(script, limits, Folder());
}

/// Declarations of `count` levels, each made of the one before.
std::string levels(int count, const std::string& first, const std::string& next) {
    std::string text = "#declare A0 = " + first + "\n";
    for (int i = 1; i <= count; ++i) {
        text += "#declare A" + std::to_string(i) + " = ";
        for (const char c : next)
            text += c == '@' ? "A" + std::to_string(i - 1) : std::string(1, c);
        text += "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("an evaluation that nobody wants any more ends without a message", "[interpret]") {
    for (const char* const endless :
         {"#while (1) #end", "#for (I, 1, 1e9) #end", "#macro M() M() #end M()"}) {
        CAPTURE(endless);
        SourceStore sources;
        Diagnostics diagnostics;
        int asked = 0;
        EvaluateOptions options;
        options.ended = [&] { return ++asked == 3; };
        const FileAccess access({}, {});
        const Loader loader(scene_reader(access), {}, {}, access);
        evaluate(sources, loader, sources.add("a.pov", endless), options, diagnostics);
        CHECK(asked == 3);
        CHECK_FALSE(diagnostics.failed());
    }
}

TEST_CASE("files that include others twice come to an end", "[interpret]") {
    const Folder folder;
    folder.put("f0.inc", "");
    for (int i = 1; i <= 40; ++i) {
        const std::string include = "#include \"f" + std::to_string(i - 1) + ".inc\"\n";
        folder.put("f" + std::to_string(i) + ".inc", include + include);
    }
    Limits limits;
    limits.files = 1000;
    CHECK(spent("#include \"f40.inc\"", limits, folder) ==
          "this scene includes or opens files more than 1000 times, which is the limit | a file "
          "that others include often can keep what it declares: #ifndef; --limit-files raises the "
          "limit\n");
    limits.files = 15;
    CHECK(spent("#include \"f3.inc\"", limits, folder) == "");
    limits.files = 14;
    CHECK(spent("#include \"f3.inc\"", limits, folder) != "");
    limits.files = 100;
    CHECK(spent("#for (I, 1, 200) #fopen F \"o.txt\" write #fclose F #end", limits, folder)
              .starts_with("this scene includes or opens files more than 100 times"));
}

TEST_CASE("functions that call others twice come to an end", "[interpret]") {
    const std::string said =
        spent(levels(60, "function(x) { x + 1 }", "function(x) { @(x) + @(-x) }"));
    CHECK(said ==
          "a call of this function can take more than 10000000 steps, which is the limit | "
          "functions that call others twice grow fast: compute a part beforehand, or pass it as an "
          "argument; --limit-function raises the limit\n");
    CHECK(spent(levels(15, "function(x) { x + 1 }", "function(x) { @(x) + @(-x) }")) == "");
    // Nested loops, by way of calls, count together.
    CHECK(spent("#declare F = function(x) { sum(i, 1, 1e5, i*x) }"
                "#declare G = function(x) { sum(i, 1, 1e5, F(i)) } #declare V = G(1);")
              .starts_with("`G` gives no value here: a sum in it does not end"));
}

TEST_CASE("objects of objects come to an end", "[interpret]") {
    for (const char* how : {"difference { object { @ } object { @ translate 0.1 } }",
                            "intersection { object { @ } object { @ translate 0.1 } }",
                            "difference { object { @ } object { @ } cutaway_textures }"}) {
        INFO(how);
        CHECK(spent(levels(60, "sphere { 0, 1 }", how))
                  .starts_with("this object has more than 20000000 parts, which is the limit of "
                               "objects | objects of objects grow fast; --limit-objects"));
    }
}

TEST_CASE("what a scene says has an end", "[interpret]") {
    Limits limits;
    limits.said_bytes = 10'000;
    const std::string message =
        "this scene has printed more than 10000 bytes, which is the limit | --limit-said, in "
        "megabytes, raises it\n";
    for (const char* what :
         {"#debug \"0123456789\"", "#debug \"\"", "#render \"x\"", "#statistics \"x\""}) {
        INFO(what);
        CHECK(spent(std::string("#while (1) ") + what + " #end", limits) == message);
    }
    CHECK(spent("#for (I, 1, 300) #debug \"0123456789\" #end", limits) == "");
}

TEST_CASE("strings have an end", "[interpret]") {
    Limits limits;
    limits.text_bytes = 10'000;
    for (const char* script :
         {"#declare S = \"x\"; #while (1) #declare S = concat(S, S); #end",
          "#declare S = \"x\"; #while (1) #declare S = concat(S, \"y\"); #end",
          "#declare S = \"x\"; #while (1) #declare S = concat(\"y\", S); #end",
          "#declare S = \"x\"; #while (1) #declare S = concat(concat(S, S), S); #end",
          "#declare S = array[1] {\"x\"} #while (1) #declare S[0] = concat(S[0], S[0]); #end",
          "#macro M(S) M(concat(S, S)) #end M(\"x\")"}) {
        INFO(script);
        CHECK(spent(script, limits)
                  .starts_with("this string has more than 10000 bytes, which is the limit | "
                               "--limit-text, in megabytes, raises it"));
    }
}

TEST_CASE("work of all kinds has an end", "[interpret]") {
    Limits limits;
    limits.work = 20'000'000;
    for (const char* script :
         {"#while (1) #declare A = array[10000]; #end",
          "#declare A = array[10000] #declare A[0] = 1; #while (1) #declare B = A; #declare B[0] = "
          "2; #end",
          "#declare F = function(x) { sum(i, 1, 1000, i*x) } #while (1) #declare A = F(2); #end",
          "#while (1) #declare A = strlen(strupr(\"abcdefghijklmnopqrstuvwxyz\")); #end",
          "#declare F = function 16000, 16000 { x } height_field { function 16000, 16000 { x*y } }",
          "plane { y, 0 pigment { image_map { function 16000, 16000 { x*y } } } }"}) {
        INFO(script);
        CHECK(spent(script, limits)
                  .starts_with("this scene takes more than 20 million steps before it is rendered, "
                               "which is the limit | strings, arrays, functions and files take "
                               "steps as well as loops; --limit-work, in millions, raises the "
                               "limit"));
    }
}

TEST_CASE("objects, meshes and points cost what is visited of them", "[interpret]") {
    Limits limits;
    limits.work = 20'000'000;
    const std::string balls = "#for (I, 0, 999) sphere { <I/10, 0, 0>, 1 } #end ",
                      points =
                          "#declare P = array[3000]; #declare R = seed(1); "
                          "#for (I, 0, 2999) #declare P[I] = <rand(R), rand(R)>; #end ",
                      mesh =
                          "#declare M = mesh { #for (I, 0, 9999) triangle { <I, 0, 0>, "
                          "<I+1, 0, 0>, <I, 1, 0> } #end } ";
    const std::string scripts[] = {
        points + "#for (I, 0, 2999) #declare C = voronoi_cell(P, I, 0, 1); #end",
        points + "#while (1) #declare D = delaunay(P); #end",
        "#declare A = scatter(difference { box { -9, 9 } " + balls + "}, 0.01);",
        "mesh { union { " + balls + "} }",
        "mesh { merge { " + balls + "} }",
        "mesh { difference { box { -9, 9 } " + balls + "} }",
        "mesh { sphere { 0, 1 } subdivide 5 }",
        "mesh { isosurface { function { x*x + y*y + z*z - 1 } } resolution 400 }",
        "#while (1) #declare M = mesh { convex_hull { " + balls + "} }; #end",
        "#declare U = union { " + balls + "} #while (1) #declare E = min_extent(U); #end",
        "#declare U = union { " + balls + "} #while (1) #declare E = max_extent(U).x + 1; #end",
        "#declare U = merge { " + balls + "} #while (1) #declare E = inside(U, <0, 0, 50>); #end",
        "#declare U = intersection { #for (I, 0, 999) plane { y, I } #end } "
        "#while (1) #declare E = inside(U, -y); #end",
        "#declare U = merge { " + balls + "} #while (1) #declare E = trace(U, -9*x, x); #end",
        mesh + "#while (1) #declare N = object { M scale 2 } #declare E = trace(N, -z, z); #end",
        "#declare H = height_field { function 1000, 1000 { x } } #while (1) "
        "#declare G = height_field { function 1000, 1000 { x } } #declare E = inside(G, 0); #end",
    };
    for (const std::string& script : scripts) {
        INFO(script);
        CHECK(spent(script, limits).starts_with("this scene takes more than 20 million steps"));
    }
}

}  // namespace candelabra
