// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/ini.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr const char* file =
    "; all pictures\r\n"
    "Width = 640 ; wide\n"
    "  +A0.1\n"
    "Input_File_Name=\"a b;c.pov\"\n"
    "\n"
    "[Low]\n"
    "Width=160\n"
    "[ High ]\n"
    "Width=1280\n"
    "more.ini\n"
    "[several]\n"
    "+W8 +H6  -A \"+Oa b.png\" '+I'c.pov ; all\n"
    "--noise=0.1";

std::string lines(std::string_view section) {
    const auto found = ini_lines(file, section);
    if (!found) return "no such section";
    std::string text;
    for (const IniLine& line : *found)
        text += std::to_string(line.number) + ":" + line.option + "|";
    return text;
}

}  // namespace

TEST_CASE("an INI file is a list of options", "[app]") {
    CHECK(lines("") == "2:Width=640|3:+A0.1|4:Input_File_Name=a b;c.pov|");
}

TEST_CASE("a line may have several switches", "[app]") {
    const auto found = ini_lines("+W8  +H6 -A\n-D +O\"a b.png\" 'c d.pov'\n", "");
    REQUIRE(found);
    std::vector<std::string> options;
    for (const IniLine& line : *found) options.push_back(line.option);
    CHECK(options == std::vector<std::string>{"+W8", "+H6", "-A", "-D", "+Oa b.png", "c d.pov"});
    CHECK(found->back().number == 2);
}

TEST_CASE("a section comes after what stands above all", "[app]") {
    CHECK(lines("low") == "2:Width=640|3:+A0.1|4:Input_File_Name=a b;c.pov|7:Width=160|");
    CHECK(lines("HIGH") ==
          "2:Width=640|3:+A0.1|4:Input_File_Name=a b;c.pov|9:Width=1280|10:more.ini|");
    CHECK(lines("several") ==
          "2:Width=640|3:+A0.1|4:Input_File_Name=a b;c.pov|12:+W8|12:+H6|12:-A|"
          "12:+Oa b.png|12:+Ic.pov|13:--noise=0.1|");
    CHECK(lines("none") == "no such section");
}

TEST_CASE("names of INI files may have a section", "[app]") {
    CHECK(ini_name("a.ini")->file == "a.ini");
    CHECK(ini_name("x/A.INI[Low res]")->section == "Low res");
    CHECK(ini_name("x/A.INI[Low res]")->file == "x/A.INI");
    CHECK_FALSE(ini_name("a.pov"));
    CHECK_FALSE(ini_name("a.pov[x]"));
    CHECK_FALSE(ini_name(".ini"));
    CHECK_FALSE(ini_name("a]"));
}

TEST_CASE("a line says its option whatever is in it", "[app]") {
    for (const std::string option :
         {"Width=10", "+W10", "--time=5", "Declare=Name=\"text\"", "--denoise", "Verbose=off",
          "+Oa b.png", "+Oa;b.png", "-Oa\"b", "Output_File_Name=a;b.png", "Output_File_Name='a'",
          "Output_File_Name= a ", "--layers=a;b", "--shard=1/2 ", "Declare=Name=\"one; two\"",
          "Declare=Name=\"one\" ; "}) {
        CAPTURE(option);
        const auto read = ini_lines("Height=1\n" + ini_line(option) + "\nHeight=2\n", "");
        REQUIRE((read && read->size() == 3));
        CHECK(read->at(1).option == option);
    }
    CHECK(ini_line("Output_File_Name=a b.png") == "Output_File_Name=a b.png");
    CHECK(ini_line("+Oa;b.png") == "+\"Oa;b.png\"");
}

}  // namespace candelabra
