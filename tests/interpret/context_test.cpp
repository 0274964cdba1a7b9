// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/context.h"

#include "bind/evaluate.h"
#include "text/excerpt.h"

#include <catch2/catch.hpp>

#include <map>

namespace candelabra {

namespace {

/// The messages about a scene whose library is in the folder "lib".
std::string said_with_library(const std::string& script) {
    const std::map<std::string, std::string> files = {
        {"lib/lamps.inc",
         "#macro Rule(A) #if (A < 1)\n#error \"too few\\n\" #end #end\n"
         "#macro Lamps(N)\nRule(N) sphere { 0, N } #end\n#macro Root(A) (sqrt(A)) #end\n"},
        {"lib/table.inc", "#macro Table(F) #local T_ = read_csv(F); #end\n"},
        {"sub/own.inc", "#include \"table.inc\"\n#macro From_Sub() Table(\"t.csv\") #end\n"},
        {"sub/t.csv", "1,2\n"},
        {"own.inc", "#macro Own(N)\nLamps(N)\n#end\n"},
        {"lib/wrong.inc", "\n#declare A = Nothing;"}};
    SourceStore sources;
    Diagnostics diagnostics;
    Loader loader(
        [&](const std::string& path) -> std::optional<std::string> {
            const auto found = files.find(path);
            return found == files.end() ? std::nullopt : std::optional(found->second);
        },
        {}, {"lib"});
    loader.set_standard_library("lib");
    evaluate(sources, loader, sources.add("main.pov", "#version 3.7;\n" + script), {}, diagnostics);
    std::string text;
    for (const Diagnostic& each : diagnostics.all()) text += format(each, sources, false);
    return text;
}

}  // namespace

TEST_CASE("what is wrong in the library is told of where the scene calls it", "[interpret]") {
    CHECK(said_with_library("#include \"lamps.inc\"\nLamps(0)\n") ==
          "error: too few\n"
          " --> main.pov:3:1\n"
          "  |\n"
          "3 | Lamps(0)\n"
          "  | ^^^^^^^^\n"
          "  |\n"
          "  = this comes from the library: lamps.inc:2\n"
          "  = in macro `Lamps`, called at main.pov:3:1\n");
    CHECK(said_with_library("#include \"lamps.inc\"\n#include \"own.inc\"\nOwn(0)\n")
              .find("--> own.inc:2:1\n") != std::string::npos);
    CHECK(said_with_library("#include \"lamps.inc\"\n#declare A = Root(-1);\n")
              .find("--> main.pov:3:14\n") != std::string::npos);
    CHECK(said_with_library("#include \"wrong.inc\"\n").find("--> main.pov:2:") !=
          std::string::npos);
}

TEST_CASE("files that a macro of the library reads are looked for beside its caller",
          "[interpret]") {
    CHECK(said_with_library("#include \"sub/own.inc\"\nFrom_Sub()") == "");
    CHECK(said_with_library("#include \"table.inc\"\nTable(\"t.csv\")")
              .find("there is no file `t.csv`") != std::string::npos);
}

TEST_CASE("each call of the library has its own message", "[interpret]") {
    const std::string said =
        said_with_library("#include \"lamps.inc\"\n#declare A = Root(-1);\n#declare B = Root(-2);");
    CHECK(said.find("--> main.pov:3:14\n") != std::string::npos);
    CHECK(said.find("--> main.pov:4:14\n") != std::string::npos);
}

}  // namespace candelabra
