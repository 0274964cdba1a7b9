// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/options.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using Words = std::vector<std::string_view>;

/// Parses options; fails on any diagnostic.
Options options_of(const Words& words) {
    Diagnostics diagnostics;
    Options options = read_options(words, diagnostics);
    for (const Diagnostic& each : diagnostics.all()) FAIL_CHECK(each.message);
    return options;
}

/// Returns the only diagnostic, with its help after a bar.
std::string complaint(const Words& words, Severity severity = Severity::error) {
    Diagnostics diagnostics;
    read_options(words, diagnostics);
    if (diagnostics.all().size() != 1)
        return "complaints: " + std::to_string(diagnostics.all().size());
    const Diagnostic& only = diagnostics.all()[0];
    CHECK(only.severity == severity);
    CHECK(only.fault == Fault::option);
    return only.message + (only.help.empty() ? "" : " | " + only.help);
}

}  // namespace

TEST_CASE("sizes, in every form and either case of letters") {
    for (const char* words :
         {"+W800", "-W800", "+w800", "Width=800", "WIDTH=800", "width=800", "+W+800", "+W8e2"}) {
        CAPTURE(words);
        CHECK(options_of({words}).render.width == 800);
    }
    CHECK(options_of({"+H1"}).render.height == 1);
    CHECK(options_of({"Height=65535"}).render.height == 65535);
    CHECK(options_of({"+W100", "+W200"}).render.width == 200);
}

TEST_CASE("quotes around a whole value are not part of it, as in POV-Ray") {
    const Options quoted = options_of({"+I\"a b.pov\"", "+O'c.png'", "Width=\"80\"", "+L\"lib\""});
    CHECK(quoted.scene == "a b.pov");
    CHECK(quoted.output == "c.png");
    CHECK(quoted.render.width == 80);
    CHECK(quoted.library_paths == std::vector<std::string>{"lib"});
    CHECK(options_of({"+Ia\"b\".pov"}).scene == "a\"b\".pov");
    // A line of an INI file has one pair of quotes, which a name within may have as well.
    for (const std::string name : {"'c.png'", "\"c.png\"", "''"}) {
        const std::string text = ini_line("Output_File_Name=" + name) + "\n";
        Diagnostics diagnostics;
        const std::vector<std::string_view> words = {"a.ini"};
        const Reader reader([&](const std::string&) { return std::optional(text); });
        CHECK(read_options(words, diagnostics, reader).output == name);
        CHECK(diagnostics.all().empty());
    }
    // The quotes of a declared string say that it is one.
    const Options declared = options_of({"Declare=Name=\"a\""});
    CHECK(declared.declares == std::vector<Declaration>{{"Name", "a"}});
}

TEST_CASE("a program may have usual settings of its own") {
    Options usual;
    usual.render.width = 800;
    usual.render.height = 600;
    Diagnostics diagnostics;
    const Words words = {"+W80"};
    const Options options = read_options(words, diagnostics, {}, {}, usual);
    CHECK(options.render.width == 80);
    CHECK(options.render.height == 600);
}

TEST_CASE("without options there are defaults") {
    const Options options = options_of({});
    CHECK(options.task == Task::render);
    CHECK_FALSE(options.scene);
    CHECK(options.to_file);
    CHECK(options.verbose);
    CHECK(options.render.width == 640);
    CHECK(options.render.height == 480);
    CHECK(options.render.antialias);
    CHECK(options.render.samples == 0);
}

TEST_CASE("what changes no picture is ignored with a warning", "[app]") {
    CHECK(complaint({"+FJ85"}, Severity::warning) ==
          "`+FJ85`: the number is ignored: JPEG files are written in one quality");
    CHECK(complaint({"Histogram_Name=a.csv"}, Severity::warning) ==
          "`Histogram_Name=a.csv` is ignored: it changes nothing in a picture");
}

TEST_CASE("a draft has few samples, unless an option says how many") {
    CHECK(options_of({"--draft"}).render.samples == 4);
    CHECK(options_of({"--samples", "16", "--draft"}).render.samples == 16);
    CHECK(options_of({"--draft", "--noise", "0.1"}).render.samples == 0);
    CHECK(options_of({"--draft", "--time", "10s"}).render.samples == 0);
}

TEST_CASE("switches that are on or off") {
    CHECK_FALSE(options_of({"-V"}).verbose);
    CHECK(options_of({"-V", "+V"}).verbose);
    CHECK_FALSE(options_of({"Verbose=off"}).verbose);
    CHECK_FALSE(options_of({"verbose=No"}).verbose);
    CHECK_FALSE(options_of({"-F"}).to_file);
    CHECK_FALSE(options_of({"Output_to_File=false"}).to_file);
    CHECK_FALSE(options_of({"-A"}).render.antialias);
    CHECK(options_of({"-A", "+A0.1"}).render.antialias);
    CHECK(options_of({"+A0.1"}).render.antialias_threshold == 0.1);
    CHECK(options_of({"Antialias_Threshold=.05"}).render.antialias_threshold == 0.05);
    CHECK(options_of({"+R5"}).render.antialias_depth == 5);
    CHECK_FALSE(options_of({"-J"}).render.jitter);
    CHECK(options_of({"-J", "+J0.5"}).render.jitter);
    CHECK(options_of({"+J0.5"}).render.jitter_amount == 0.5);
    CHECK(options_of({"Jitter_Amount=2", "Jitter=off"}).render.jitter_amount == 2);
    CHECK(options_of({"+AG1"}).render.antialias_gamma == 1);
}

TEST_CASE("formats") {
    struct Case {
        const char* word;
        PictureType type;
        std::optional<int> bits;
        bool compressed;
    };
    const Case cases[] = {
        {"+FN", PictureType::png, {}, false},
        {"+fn16", PictureType::png, 16, false},
        {"+FE", PictureType::exr, {}, false},
        {"+FH", PictureType::hdr, {}, false},
        {"+FP", PictureType::ppm, {}, false},
        {"+FT", PictureType::tga, {}, false},
        {"+FC", PictureType::tga, {}, true},
        {"+FJ", PictureType::jpeg, {}, false},
        {"+FB", PictureType::bmp, {}, false},
        {"+FS", PictureType::png, {}, false},
        {"+FI16", PictureType::tiff, 16, false},
        {"+fw", PictureType::webp, {}, false},
        {"Output_File_Type=E", PictureType::exr, {}, false},
    };
    for (const Case& each : cases) {
        CAPTURE(each.word);
        const Options options = options_of({each.word});
        CHECK(options.type == each.type);
        CHECK(options.bits == each.bits);
        CHECK(options.compressed == each.compressed);
    }
    CHECK_FALSE(options_of({"+F"}).type);
}

TEST_CASE("our own options, with a blank or an equals sign") {
    for (const Words& words :
         {Words{"--samples", "64"}, Words{"--samples=64"}, Words{"--SAMPLES=64"}})
        CHECK(options_of(words).render.samples == 64);
    CHECK(options_of({"--shadow-rays", "4"}).render.shadow_rays == 4);
    CHECK(options_of({"--seed=7"}).render.seed == 7);
    CHECK(options_of({"--threads", "3"}).render.threads == 3);
    CHECK(options_of({"+WT3"}).render.threads == 3);
    CHECK(options_of({"--stats", "a b.json"}).stats_file == "a b.json");
    CHECK(std::holds_alternative<ConstantAlpha>(
        *options_of({"--light-sampler", "constant_alpha"}).render.light_sampler));
    CHECK(std::holds_alternative<BoundingBoxes>(
        *options_of({"--index=bounding_boxes"}).render.index));
    CHECK(options_of({"--check"}).task == Task::check);
    CHECK(options_of({"--check=syntax"}).task == Task::check_syntax);
    CHECK(options_of({"--dump", "tokens"}).task == Task::dump_tokens);
    CHECK(options_of({"--dump=tree"}).task == Task::dump_tree);
    CHECK(options_of({"--dump", "scene"}).task == Task::dump_scene);
    CHECK(options_of({"--dump", "world"}).task == Task::dump_world);
    CHECK(options_of({"--dump", "index"}).task == Task::dump_index);
    CHECK(options_of({"--version"}).task == Task::version);
    CHECK(options_of({"+K0.5"}).facts.clock == 0.5);
    CHECK(options_of({"+Lone", "Library_Path=two"}).library_paths ==
          std::vector<std::string>{"one", "two"});
}

TEST_CASE("help and descriptions take words behind them") {
    CHECK(options_of({"--help"}).task == Task::help);
    CHECK(options_of({"-h"}).task == Task::help);
    CHECK(options_of({"+H"}).task == Task::help);
    CHECK(options_of({"--help", "light", "samplers", "-V"}).topic == "light samplers");
    CHECK(options_of({"--help=sphere"}).topic == "sphere");
    const Options options = options_of({"--describe", "roff", "options"});
    CHECK(options.task == Task::describe);
    CHECK(options.form == ManualForm::roff);
    CHECK(options.topic == "options");
}

TEST_CASE("scenes have any name") {
    struct Case {
        Words words;
        const char* scene;
    };
    const Case cases[] = {
        {{"scene.pov"}, "scene.pov"},
        {{"a b.pov"}, "a b.pov"},
        {{"a=b.pov"}, "a=b.pov"},
        {{"./a=b"}, "./a=b"},
        {{"--", "-dash.pov"}, "-dash.pov"},
        {{"--", "+W1"}, "+W1"},
        {{"--", "--help"}, "--help"},
        {{"a%%%.pov"}, "a%%%.pov"},
        {{"bücher.pov"}, "bücher.pov"},
        {{"+Iscene.pov"}, "scene.pov"},
        {{"+I-"}, "-"},
        {{"-"}, "-"},
        {{"Input_File_Name=a=b"}, "a=b"},
        {{"+Ia", "+Ib"}, "b"},
        {{"a", "+W10", "-V"}, "a"},
    };
    for (const Case& each : cases) CHECK(options_of(each.words).scene == each.scene);
}

TEST_CASE("every keyword is a long option, too, and a switch may be followed by its value") {
    const Options options =
        options_of({"--width", "100", "--height=50", "-o", "x.png", "--output-alpha",
                    "--jitter=off", "--antialias", "--initial-clock", "-2", "a.pov"});
    CHECK(options.render.width == 100);
    CHECK(options.render.height == 50);
    CHECK(options.output == "x.png");
    CHECK(options.alpha);
    CHECK_FALSE(options.render.jitter);
    CHECK(options.animation.initial_clock == -2);
    CHECK(options.scene == "a.pov");
    CHECK(options_of({"+W", "20", "+KFI", "-3", "a.pov"}).animation.initial_frame == -3);
    CHECK(options_of({"--output", "y.png", "a.pov"}).output == "y.png");
    CHECK(options_of({"--Output-File-Name=z.png", "a.pov"}).output == "z.png");
}

TEST_CASE("names are declared with numbers and strings") {
    const Options options = options_of({"Declare=Depth=5", "declare=Name=\"a = b\"",
                                        "Declare=Half=.5", "Declare=On=yes", "Declare=Depth=6"});
    const std::vector<Declaration> expected = {
        {"Depth", 5.0}, {"Name", "a = b"}, {"Half", 0.5}, {"On", 1.0}, {"Depth", 6.0}};
    CHECK(options.declares == expected);
}

TEST_CASE("keywords are switched by numbers, and spelled in either way, as in POV-Ray") {
    CHECK(options_of({"Antialias=0.001"}).given.size() == 1);
    CHECK(options_of({"Output_Alpha=2"}).alpha);
    CHECK_FALSE(options_of({"Output_Alpha=0.0"}).alpha);
    CHECK(options_of({"Bits_Per_Colour=16"}).bits == 16);
    CHECK(options_of({"Greyscale_Output=on"}).grey);
    CHECK(options_of({"--greyscale-output"}).grey);
    CHECK(options_of({"-version"}).task == Task::version);
    CHECK(options_of({"-help"}).task == Task::help);
    CHECK(options_of({"File_Gamma=BT709"}).file_gamma < -1);
}

TEST_CASE("POV-Ray's switches that change nothing are taken in silence") {
    for (const char* word : {"+D", "-D", "+D0C", "+P", "-P", "Display=on", "Pause_When_Done=off",
                             "+Q9", "+Q11", "+HR", "File_Gamma=sRGB", "-UA", "-C", "-KC"}) {
        CAPTURE(word);
        options_of({word});
    }
}

TEST_CASE("POV-Ray's switches that leave the picture as it is are ignored with a warning") {
    CHECK(complaint({"+MB1"}, Severity::warning) ==
          "`+MB1` is ignored: objects are always found through an index; see --index");
    for (const char* word : {"-CC", "+BS16", "+MB1", "-UR", "+SP8", "Bounding=on"}) {
        CAPTURE(word);
        CHECK(complaint({word}, Severity::warning).find("is ignored") != std::string::npos);
    }
}

TEST_CASE("every wrong argument has one message") {
    struct Case {
        Words words;
        std::string expected;
    };
    const Case cases[] = {
        {{"+W0"}, "`+W0`: width must be a whole number from 1 to 65535, but it is `0`"},
        {{"+W640.5"}, "`+W640.5`: width must be a whole number from 1 to 65535, but it is `640.5`"},
        {{"+Wide"}, "`+Wide`: width must be a whole number from 1 to 65535, but it is `ide`"},
        {{"+W"}, "`+W`: needs a value: `+Wn`"},
        {{"+W", "-V", "a.pov"}, "`+W`: needs a value: `+Wn`"},
        {{"Width="}, "`Width=`: needs a value"},
        {{"+Anan"}, "`+Anan`: antialias_threshold must be a number from 0 on, but it is `nan`"},
        {{"--samples"}, "`--samples`: needs a value: `--samples n`"},
        {{"--samples="}, "`--samples=`: needs a value: `--samples n`"},
        {{"--samples", "-4"},
         "`--samples`: samples must be a whole number from 0 to 1000000, but it is `-4`"},
        {{"--sample=4"}, "`--sample=4`: there is no such option | did you mean `--samples`?"},
        {{"--sample", "4"}, "`--sample`: there is no such option | did you mean `--samples`?"},
        {{"--widht", "100", "a.pov"},
         "`--widht`: there is no such option | did you mean `--width`?"},
        {{"--frobnicate", "x", "a.pov"}, "`--frobnicate`: there is no such option"},
        {{"--output-alpha=perhaps"}, "`--output-alpha=perhaps`: the value must be on or off"},
        {{"--check", "--export-mesh", "m.ply"},
         "`--export-mesh`: a run checks, dumps, picks, exports, measures or balances a scene, one of "
         "them only"},
        {{"--export-mesh", "m.ply", "--dump", "scene"},
         "`--dump`: a run checks, dumps, picks, exports, measures or balances a scene, one of them "
         "only"},
        {{"--dump", "scene", "--check"},
         "`--check`: a run checks, dumps, picks, exports, measures or balances a scene, one of them "
         "only"},
        {{"--frames", "1,"},
         "`--frames`: needs numbers of frames, and ranges of them | "
         "3,7,12-20,9-5"},
        {{"--version=2"}, "`--version=2`: takes no value"},
        {{"-samples"}, "`-samples`: there is no such option | did you mean `--samples`?"},
        {{"+Z"}, "`+Z`: there is no such option"},
        {{"Widht=5"}, "`Widht=5`: there is no such keyword | did you mean `Width=`?"},
        {{"banana=5"}, "`banana=5`: there is no such keyword | if it is a file: `./banana=5`"},
        {{"Verbose=maybe"}, "`Verbose=maybe`: the value must be on or off"},
        {{"+FX"},
         "`+FX`: `X` is no picture format | N png, E OpenEXR, H Radiance HDR, P ppm, T tga, J "
         "jpeg, B bmp, I tiff, W webp, C compressed tga"},
        {{"+FN12"}, "`+FN12`: a channel can have 8 or 16 bits"},
        {{"--light-sampler", "octree"},
         "`--light-sampler`: there is no light sampler `octree` | there are every_light, "
         "constant_alpha, linear_alpha, light_bvh, light_octree"},
        {{"--light-sampler=ligth_octree"},
         "`--light-sampler=ligth_octree`: there is no light sampler `ligth_octree` | did you mean "
         "`light_octree`? there are every_light, constant_alpha, linear_alpha, light_bvh, "
         "light_octree"},
        {{"--index", "octree"},
         "`--index`: there is no index `octree` | there are kd_tree, bounding_boxes"},
        {{"--dump", "film"},
         "`--dump`: there is no stage `film` | tokens, tree, scene, world or "
         "index"},
        {{"--check=all"}, "`--check=all`: only --check and --check=syntax are offered"},
        {{"Declare=Depth"},
         "`Declare=Depth`: needs a name and a value | Declare=Depth=5, 'Declare=Title=\"text\"'"},
        {{"Declare=1a=2"},
         "`Declare=1a=2`: needs a name and a value | Declare=Depth=5, 'Declare=Title=\"text\"'"},
        {{"Declare=sphere=2"},
         "`Declare=sphere=2`: `sphere` is a word of the language and cannot be declared | "
         "Declare=Depth=5, 'Declare=Title=\"text\"'"},
        {{"Declare=a=1+2"},
         "`Declare=a=1+2`: the value of `a` must be a number, a string in quotes, or a vector | "
         "for a string: 'Declare=a=\"text\"'"},
        {{"a.pov", "b.pov"},
         "`b.pov`: only one scene can be rendered at a time, and there is already `a.pov`"},
        {{"render.ini"}, "`render.ini`: there is no such file that can be read"},
        {{""}, "``: a file name cannot be empty"},
        {{"+KIx"}, "`+KIx`: initial_clock must be a number, but it is `x`"},
        {{"+GI"}, "`+GI`: needs the name of a file | +GIall.ini"},
        {{"Create_Ini=on"}, "`Create_Ini=on`: needs the name of a file | +GIall.ini"},
        {{"+UF"}, "`+UF`: is not offered: no screen has interlaced fields any more"},
        {{"File_Gamma=0"}, "`File_Gamma=0`: needs sRGB, bt709, bt2020 or a number from 0.1 to 10"},
        {{"+\x1b[2J"}, "`+\xe2\x90\x9b[2J`: there is no such option"},
    };
    for (const Case& each : cases) CHECK(complaint(each.words) == each.expected);
}

TEST_CASE("an INI file is read where it stands, and may name others", "[app]") {
    const Reader files = [](const std::string& name) -> std::optional<std::string> {
        if (name == "a.ini") return "Width=10\nb.ini[Small]\n+H7\n[Wide]\nWidth=900\n";
        if (name == "b.ini") return "Height=3\n[Small]\nHeight=5\n--seed=9\nscene.pov";
        if (name == "loop.ini") return "loop.ini";
        if (name == "other.ini") return "include_ini=a.ini[wide]";
        if (name == "many.ini") return "All_File=\n+W8  -A \"+H6\"\ns.pov";
        if (name == "empty.ini")
            return "Width=4\nAll_File=\nPre_Frame_Command=\nFinal_Frame=\nscene.pov";
        if (name == "wrong.ini") return "\nWidht=3";
        return {};
    };
    const auto said = [&](const Words& words) {
        Diagnostics diagnostics;
        const Options options = read_options(words, diagnostics, files);
        if (!diagnostics.all().empty()) return diagnostics.all()[0].message;
        return std::to_string(options.render.width) + "x" + std::to_string(options.render.height) +
               " " + std::to_string(options.render.seed) + " " + options.scene.value_or("");
    };
    CHECK(said({"a.ini"}) == "10x7 9 scene.pov");
    CHECK(said({"a.ini[wide]", "+W20"}) == "20x7 9 scene.pov");
    CHECK(said({"+W20", "a.ini[wide]"}) == "900x7 9 scene.pov");
    CHECK(said({"a"}) == "10x7 9 scene.pov");
    CHECK(said({"a[wide]"}) == "900x7 9 scene.pov");
    CHECK(said({"many.ini"}) == "8x6 0 s.pov");
    CHECK(said({"Include_Ini=a.ini"}) == "10x7 9 scene.pov");
    CHECK(said({"other.ini"}) == "900x7 9 scene.pov");
    CHECK(said({"Include_Ini=s.pov"}) == "`Include_Ini=s.pov`: names no INI file");
    CHECK(said({"a.ini[none]"}) == "`a.ini[none]`: the file has no section [none]");
    CHECK(said({"empty.ini"}) == "empty.ini:4: `Final_Frame=` has no value and is ignored");
    CHECK(said({"wrong.ini"}) == "wrong.ini:2: `Widht=3`: there is no such keyword");
    CHECK(said({"loop.ini"}) ==
          "loop.ini:1: `loop.ini`: INI files name each other more than 10 "
          "deep");
}

TEST_CASE("INI files that name themselves often are not read without end", "[app]") {
    std::string text;
    for (int i = 0; i < 20; ++i) text += "bomb.ini\n";
    int files = 0;
    const Reader reader = [&](const std::string& name) -> std::optional<std::string> {
        if (name != "bomb.ini") return std::nullopt;
        ++files;
        return text;
    };
    const std::vector<std::string_view> words = {"bomb.ini"};
    Diagnostics diagnostics;
    read_options(words, diagnostics, reader);
    CHECK(diagnostics.failed());
    CHECK(files <= 1000);
}

TEST_CASE("the file with everybody's settings has any name and comes first", "[app]") {
    const Reader files = [](const std::string& name) -> std::optional<std::string> {
        if (name == "settings") return "Width=10\nHeight=20\n";
        if (name == "parts.ini") return "[Small]\nWidth=5\n";
        return {};
    };
    const auto size = [&](const Words& words, const std::string& settings) {
        Diagnostics diagnostics;
        const Options options = read_options(words, diagnostics, files, settings);
        if (diagnostics.failed()) return diagnostics.all()[0].message;
        return std::to_string(options.render.width) + "x" + std::to_string(options.render.height);
    };
    CHECK(size({"+H30", "a.pov"}, "settings") == "10x30");
    CHECK(size({"a.pov"}, "parts.ini[small]") == "5x480");
    CHECK(size({"a.pov"}, "none") == "`none`: there is no such file that can be read");
}

TEST_CASE("no file that may come with a scene gives it permissions", "[app]") {
    const Reader files = [](const std::string&) -> std::optional<std::string> {
        return "--allow-write=/\n--allow-commands";
    };
    const auto allowed = [&](const Words& words, const std::string& settings) {
        Diagnostics diagnostics;
        const Options options = read_options(words, diagnostics, files, settings);
        CHECK(diagnostics.failed() == options.writable.empty());
        return options.commands.allowed;
    };
    CHECK_FALSE(allowed({"a.ini"}, ""));
    CHECK_FALSE(allowed({"a.pov"}, "candelabra.ini"));
    CHECK(allowed({"a.pov"}, "/home/me/.config/candelabra/candelabra.ini"));
    CHECK(allowed({"--allow-write=/", "--allow-commands", "a.pov"}, ""));
    const auto given = options_of({"--allow-commands", "+W9"}).given;
    REQUIRE(given.size() == 1);
    CHECK(given[0].line == "Width=9");
}

TEST_CASE("frames, header and version have their options", "[app]") {
    const Options options = options_of({"+KFI2", "Final_Frame=20", "+KF6.5", "+KC", "+SF0.5",
                                        "+STP3", "--skip-existing", "+HIhead.inc", "Version=3.5"});
    CHECK(options.animation.initial_frame == 2);
    CHECK(options.animation.final_frame == 20);
    CHECK(options.animation.final_clock == 6.5);
    CHECK(options.animation.cyclic);
    CHECK(options.animation.subset_start_frame == 0.5);
    CHECK(options.animation.frame_step == 3);
    CHECK(options.animation.skip_existing);
    CHECK(options.facts.header == "head.inc");
    CHECK(options.facts.version == 3.5);
}

TEST_CASE("all options together are lines of an INI file", "[app]") {
    const auto lines = [](const Options& of) {
        std::vector<std::string> all;
        for (const GivenOption& each : of.given) all.push_back(each.line);
        return all;
    };
    const Options options =
        options_of({"+W30", "-F", "+A0.2", "--seed", "4", "Declare=a=1", "-V", "x.pov"});
    CHECK(lines(options) == std::vector<std::string>{"Width=30", "Output_to_File=off", "+A0.2",
                                                     "--seed=4", "Declare=a=1", "Verbose=off",
                                                     "Input_File_Name=x.pov"});
    CHECK(lines(options_of({"-A0.2"})) == std::vector<std::string>{"-A0.2"});
    CHECK(options_of({"+GIa.ini"}).ini_file == "a.ini");
    CHECK(options_of({"Create_Ini=a.ini"}).ini_file == "a.ini");
    CHECK_FALSE(options_of({"+GIa.ini", "-GI"}).ini_file);
    CHECK_FALSE(options_of({"+GIa.ini", "Create_Ini=off"}).ini_file);
}

}  // namespace candelabra
