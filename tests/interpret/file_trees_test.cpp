// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/file_trees.h"

#include "bind/evaluate.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using Files = std::map<std::string, std::string>;

/// The output of a scene of these files, or its first message.
std::string said(const Files& files) {
    SourceStore sources;
    Diagnostics diagnostics;
    const Loader loader([&](const std::string& path) {
        const auto file = files.find(path);
        return file == files.end() ? std::nullopt : std::optional(file->second);
    });
    std::string printed;
    EvaluateOptions options;
    options.print = [&](std::string_view text) { printed += text; };
    evaluate(sources, loader, sources.add("main.pov", files.at("main.pov")), options, diagnostics);
    for (const Diagnostic& each : diagnostics.all())
        if (each.severity == Severity::error)
            return sources.name(each.span.source) + ": " + each.message;
    return printed;
}

const std::string print = "#macro P(Number) #debug concat(str(Number, 0, 0), \" \") #end ";

}  // namespace

TEST_CASE("files share the macros that open braces", "[files]") {
    const auto [files, prints] = GENERATE(table<Files, std::string>({
        {{{"main.pov",
           "#include \"a.inc\" #declare O = Begin(2) box { -1, 1 } End() "
           "P(max_extent(O).x)"},
          {"a.inc", "#macro Begin(R) union { sphere { 0, R } #end #macro End() } #end"}},
         "2 "},
        // A macro of a file that is included once, through another file.
        {{{"main.pov",
           "#include \"b.inc\" #include \"b.inc\" #declare O = Begin() box { 0, 3 } } "
           "P(max_extent(O).x)"},
          {"b.inc", "#ifdef (B) #else #declare B = 1; #include \"a\" #end"},
          {"a.inc", "#ifndef (A) #declare A = 1; #macro Begin() union { #end #end"}},
         "3 "},
        // A file that uses a macro of the file that includes it.
        {{{"main.pov", "#macro Begin() union { #end #include \"part.inc\" P(max_extent(O).x)"},
          {"part.inc", "#declare O = Begin() box { 0, 4 } }"}},
         "4 "},
        {{{"main.pov",
           "#macro Begin() union { #end #declare O = Begin() box { 0, 1 } } "
           "#include concat(\"part\", \".inc\") P(max_extent(O).x)"},
          {"part.inc", "#declare O = Begin() box { 0, 4 } }"}},
         "4 "},
        // Halves of parentheses and vectors, and operators; with numbers and strings of their own.
        {{{"main.pov",
           "#include \"a.inc\" P(Half() 3)) P(2 Times() 3) P((1 More())) "
           "P((<1, 2, Tail()).z) #debug Quoted() \"!\")"},
          {"a.inc",
           "#macro Half() (4 + #end #macro Times() * #end #macro More() + 20 #end "
           "#macro Tail() 7> #end #macro Quoted() concat(\"a\\\"\", #end"}},
         "7 6 21 7 a\"!"},
        // The last definition counts, whatever it is.
        {{{"main.pov", "#include \"a.inc\" #include \"b.inc\" P(A())"},
          {"a.inc", "#macro A() union { #end"},
          {"b.inc", "#macro A() 5 #end"}},
         "5 "},
        {{{"main.pov", "#include \"a.inc\" P((A() 5))"},
          {"a.inc", "#macro A() union { #end #macro A() 3 * #end"}},
         "15 "},
        // Files that do not exist, are never reached, or include themselves.
        {{{"main.pov", "#ifdef (Never) #include \"b.inc\" #include \"none.inc\" #end P(1)"},
          {"b.inc", "sphere {"}},
         "1 "},
        {{{"main.pov", "#include \"a.inc\" P(D)"},
          {"a.inc",
           "#ifndef (D) #declare D = 0; #end #if (D < 3) #declare D = D + 1; "
           "#include \"a.inc\" #end"}},
         "3 "},
        // The text and the version at the time of the walk count.
        {{{"main.pov", "#declare V = 3.0; #version V; #include \"v.inc\""},
          {"v.inc", "#if (version < 3.5) P(1) union { #else P(2) merge { #end sphere { 0, 1 } }"}},
         "1 "},
    }));
    INFO(files.at("main.pov"));
    Files all = files;
    all["main.pov"] = print + all["main.pov"] + " sphere { 0, 1 }";
    CHECK(said(all) == prints);
}

TEST_CASE("what is wrong in an open macro is told of in its file", "[files]") {
    const auto [main, says] = GENERATE(table<std::string, std::string>({
        {"#include \"a.inc\" Begin()", "a.inc: this `{` is not closed before `#end`"},
        {"#include \"a.inc\" End()", "a.inc: `}` closes nothing that is open"},
        {"#include \"a.inc\" Begin(1) End()",
         "main.pov: macro `Begin` takes 0 arguments, but here is 1"},
        // No file calls it, but another scene may.
        {"#include \"a.inc\"", ""},
        {"#include \"b.inc\"", "b.inc: `{` has no end"},
    }));
    INFO(main);
    CHECK(said({{"main.pov", main + " sphere { 0, 1 }"},
                {"a.inc", "#macro Begin() union { #end #macro End() } #end"},
                {"b.inc", "union {"}}) == says);
}

}  // namespace candelabra
