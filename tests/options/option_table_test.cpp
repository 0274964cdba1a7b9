// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_table.h"

#include "options/option_help.h"

#include <catch2/catch.hpp>

#include <array>
#include <set>

namespace candelabra {

TEST_CASE("no switch, keyword or word stands in the table twice, and every row leads somewhere") {
    std::set<std::string_view> letters, keywords, words;
    for (const OptionRow& row : option_table()) {
        CAPTURE(row.letters, row.keyword, row.word);
        CHECK((row.letters.empty() || letters.insert(row.letters).second));
        CHECK((row.keyword.empty() || keywords.insert(row.keyword).second));
        CHECK((row.word.empty() || words.insert(row.word).second));
        CHECK_FALSE((row.letters.empty() && row.keyword.empty() && row.word.empty()));
        CHECK((row.takes != Takes::value || !row.parameter.empty()));
        if (row.unoffered != Unoffered::no) continue;
        const int ways = (row.store != nullptr) + (find_setting(row.field).item != nullptr) +
                         (row.own.type != OptionField::Type::none);
        CHECK(ways == 1);
        CHECK_FALSE(manual_entry(row).help.empty());
    }
}

TEST_CASE("every setting of the run but the sampler's parameters has an option") {
    for (const FieldInfo& field : RenderSettings::vocabulary.fields) {
        CAPTURE(field.name);
        bool found = false;
        for (const OptionRow& row : option_table()) found = found || row.field == field.name;
        CHECK(found);
    }
}

TEST_CASE("every option has a long name of its own, and stands in a group") {
    std::set<std::string> names;
    for (const OptionRow& row : option_table()) {
        CAPTURE(row.letters, row.keyword);
        const std::string name = long_name(row);
        CHECK((name.empty() ? row.letters == "GI" : names.insert(name).second));
        if (!name.empty()) CHECK(find_option(name) == &row);
        CHECK((row.group == OptionGroup::povray) == (row.unoffered != Unoffered::no));
    }
    CHECK(find_option("with") == nullptr);
}

TEST_CASE("every switch and keyword of POV-Ray has a meaning or a one-line answer") {
    struct Case {
        std::vector<std::string_view> ways;
        std::string_view answer = {};  ///< the message; empty: none
    };
    const Case cases[] = {
        {{"+Ia.pov", "Input_File_Name=a.pov"}},
        {{"+Oa", "Output_File_Name=a"}},
        {{"+W8", "Width=8", "+H8", "Height=8"}},
        {{"+FN", "+FP", "+FT", "+FC", "+FJ", "+FE", "+FH", "+FB", "+FS", "+FN16", "-F"}},
        {{"Output_File_Type=N", "Output_to_File=off", "Bits_Per_Color=16"}},
        {{"+FNg", "+FN16g", "Grayscale_Output=on"}},
        {{"+UA", "-UA", "Output_Alpha=on"}},
        {{"+A", "+A0.1", "-A", "Antialias=on", "Antialias_Threshold=0.1"}},
        {{"+AM2", "Sampling_Method=1", "+AM3"}},
        {{"+R3", "Antialias_Depth=3"}},
        {{"+J0.5", "-J", "Jitter=off", "Jitter_Amount=1"}},
        {{"+AG2.5", "Antialias_Gamma=2"}},
        {{"+Q0", "+Q11", "Quality=9"}},
        {{"+WT2", "Work_Threads=2"}},
        {{"+BS32", "Render_Block_Size=8", "+RP1", "Render_Pattern=0", "+RS2",
          "Render_Block_Step=2"},
         "is ignored: tiles are made in their own order"},
        {{"+SR1", "+ER0.5", "+SC1", "+EC8", "Start_Row=1", "End_Row=2", "Start_Column=1",
          "End_Column=0.5"}},
        {{"+C", "-C", "Continue_Trace=on"}},
        {{"+P", "-P", "Pause_When_Done=on", "+D", "-D", "+D0", "+DGT", "Display=off"}},
        {{"+SP8", "+EP2", "Preview_Start_Size=8", "Preview_End_Size=1"},
         "is ignored: no preview is shown"},
        {{"+V", "-V", "Verbose=on"}},
        {{"+X", "-X", "+X10", "Test_Abort=on", "Test_Abort_Count=5"}},
        {{"+Lfolder", "Library_Path=folder"}},
        {{"+HIa.inc", "Include_Header=a.inc"}},
        {{"+MV3.7", "Version=3.6"}},
        {{"Declare=Depth=5"}},
        {{"+K0.5", "Clock=0.5"}},
        {{"+KFI1", "+KFF9", "Initial_Frame=1", "Final_Frame=9", "+KI0", "+KF1", "Initial_Clock=0",
          "Final_Clock=2"}},
        {{"+SF2", "+EF0.5", "Subset_Start_Frame=2", "Subset_End_Frame=3", "+STP2", "Frame_Step=2"}},
        {{"+KC", "-KC", "Cyclic_Animation=on"}},
        {{"+UF", "+UO", "Field_Render=on", "Odd_Field=on"},
         ": is not offered: no screen has interlaced fields any more"},
        {{"-UF", "-UO", "Field_Render=off", "Odd_Field=off"}},
        {{"+MB3", "-MB", "Bounding=on", "Bounding_Threshold=3", "+BM2", "Bounding_Method=1", "+UR",
          "Remove_Bounds=on", "-SU", "Split_Unions=off", "+UL", "Light_Buffer=on", "+UV",
          "Vista_Buffer=off"},
         "is ignored: objects are always found through an index; see --index"},
        {{"+HR", "High_Reproducibility=on"}},
        {{"+RFa.rad", "+RFI", "+RFO", "Radiosity_File_Name=a", "Radiosity_From_File=on",
          "Radiosity_To_File=on"},
         ": is not offered: radiosity has no cache"},
        {{"+RVP", "Radiosity_Vain_Pretrace=off"}, "is ignored: radiosity has no cache"},
        {{"+TH", "+THB2", "Dither=on"}, ": is not offered: pictures are not dithered"},
        {{"Dither_Method=FS"}, ": is not offered: pictures are not dithered"},
        {{"-TH", "Dither=off"}},
        {{"File_Gamma=sRGB", "File_Gamma=bt709", "File_Gamma=2.2"}},
        {{"Display_Gamma=2.2"}, "is ignored: no preview is shown"},
        {{"+GA",
          "-GA",
          "+GAall.txt",
          "+GD",
          "+GF",
          "+GR",
          "+GS",
          "-GW",
          "All_Console=off",
          "All_File=a.txt",
          "Debug_Console=on",
          "Debug_File=a.txt",
          "Fatal_Console=on",
          "Fatal_File=a.txt",
          "Render_Console=on",
          "Render_File=a.txt",
          "Statistic_Console=on",
          "Statistic_File=a.txt",
          "Warning_Console=on",
          "Warning_File=a.txt"}},
        {{"+GIa.ini", "Create_Ini=a.ini", "Create_Ini=off"}},
        {{"+WL5", "Warning_Level=0"}},
        {{"+MI64", "Max_Image_Buffer_Memory=64"}, "is ignored: pictures are kept in memory"},
        {{"+SS7", "Stochastic_Seed=7"}, "is ignored: see --seed"},
        {{"+AC0.9", "Antialias_Confidence=0.9"}, "is ignored: see --noise"},
        {{"Pre_Scene_Command=true", "Post_Scene_Command=true", "Pre_Frame_Command=true",
          "Post_Frame_Command=true", "User_Abort_Command=true", "Fatal_Error_Command=true",
          "Pre_Scene_Return=I", "Post_Scene_Return=-F", "Pre_Frame_Return=S",
          "Post_Frame_Return=Q"}},
        {{"User_Abort_Return=I", "Fatal_Error_Return=I"}, "is ignored: the run has ended then"},
        {{"--help", "--version"}},
        {{"--benchmark"}, "is ignored: there is no scene of its own to measure"},
        {{"Continue_Trace_Log=a"}, "is ignored: states have names of their own; see STATES"},
    };
    for (const Case& each : cases)
        for (const std::string_view way : each.ways) {
            Diagnostics diagnostics;
            read_options(std::array{way}, diagnostics);
            const std::string said = diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
            CAPTURE(way, said, each.answer);
            CHECK(diagnostics.all().size() == (each.answer.empty() ? 0 : 1));
            CHECK(said.find(each.answer) != said.npos);
        }
}

}  // namespace candelabra
