// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command_line.h"

#include "options/read_words.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace candelabra {

TEST_CASE("the command that makes a picture says what options come to", "[app]") {
    struct Case {
        std::vector<std::string_view> words;
        const char* command;
    };
    const auto [words, command] = GENERATE(Catch::Generators::values<Case>({
        {{"x/a.pov"}, "candelabra a.pov +W640 +H480"},
        {{"Width=20", "-V", "+WT3", "+Oz.png", "-"}, "candelabra - +W20 +H480"},
        {{"+Ia=b c.pov"}, "candelabra '+Ia=b c.pov' +W640 +H480"},
        {{"a.pov", "+A0.1", "--samples", "4"}, "candelabra a.pov +W640 +H480 --samples 4"},
        {{"a.pov", "+A0.1"}, "candelabra a.pov +W640 +H480 Antialias_Threshold=0.1"},
        {{"a.pov", "+AM2"}, "candelabra a.pov +W640 +H480 +AM2"},
        {{"a.pov", "--time", "1m"}, "candelabra a.pov +W640 +H480 --time 60s"},
        {{"a.pov", "Declare=T=\"a b\"", "Declare=N=2"},
         "candelabra a.pov +W640 +H480 'Declare=T=\"a b\"' Declare=N=2"},
        {{"a.pov", "--shard", "2/3", "--seed", "5", "+Q3"},
         "candelabra a.pov +W640 +H480 --seed 5 +Q3"},
        {{"a.pov", "+UA", "--layers", "normal,albedo", "+Oa.exr"},
         "candelabra a.pov +UA +W640 +H480 --layers albedo,normal"},
        {{"a.pov", "--index", "bounding_boxes"}, "candelabra a.pov +W640 +H480"},
        {{"a.pov", "+SR0.5", "+EC100", "--light-sampler", "light_bvh"},
         "candelabra a.pov +W640 +H480 +SR241 +EC100 --light-sampler light_bvh"},
        {{"a.pov", "--luminaires", "none", "+KFF9"},
         "candelabra a.pov +W640 +H480 +KFF9 --luminaires none"},
    }));
    CHECK(command_line(read(words)) == command);
}

TEST_CASE("a picture tells the command that makes it again", "[app]") {
    const Shell shell;
    shell.write("a b.pov", std::string(lit_scene) + "sphere { clock*x, 0.1 }");
    const std::string way = GENERATE(
        "", "--samples 3", "-A --seed 7", "+A0.1 +R2", "--noise 0.4 --shadow-rays 2",
        "Declare=Size=0.5 +K0.25 File_Gamma=1.8", "-A File_Gamma=bt2020", "+Q3 +SR3 +ER9 +SC0.25",
        "--light-sampler light_bvh", "+KFI1 +KFF4 +KF2 +KC +SF3 +EF3", "+MV3.6 --threads 1");
    const auto make = [&](const std::string& options, const std::string& name) {
        INFO(options);
        REQUIRE(std::system(("cd " + shell.folder.string() + "; " CANDELABRA_BINARY + options +
                             " -V +O" + name + ".ppm")
                                .c_str()) == 0);
        const bool frame = options.find("KFF") != options.npos;
        return shell.content(name + (frame ? "3.ppm" : ".ppm"));
    };
    const std::string picture = make(" 'a b.pov' +W20 +H15 " + way, "one");
    const std::string_view sign = "made by: candelabra";
    const std::size_t at = picture.find(sign);
    REQUIRE(at != picture.npos);
    const std::size_t end = picture.find('\n', at), begin = at + sign.size();
    CHECK(make(picture.substr(begin, end - begin), "again") == picture);
}

}  // namespace candelabra
