// SPDX-License-Identifier: GPL-3.0-or-later
// The options of POV-Ray that Candelabra does not offer, with what becomes of each. Only the table
// of options includes it.
#pragma once

#include "options/option_rows.h"

#include <array>
#include <string_view>

namespace candelabra::povray_options {

using namespace option_rows;

inline constexpr std::string_view no_radiosity = "radiosity has no cache";
inline constexpr std::string_view no_preview = "no preview is shown";
inline constexpr std::string_view order =
    "tiles are made in their own order, all of them better and better";
inline constexpr std::string_view older = "it changes nothing in a picture";
inline constexpr std::string_view over = "the run has ended then";
inline constexpr std::string_view index = "objects are always found through an index; see --index";

template <Unoffered how>
constexpr OptionRow unoffered(Term letters, Term keyword, Takes takes, Term name, Term help) {
    OptionRow row{letters, keyword, {}, name, takes, help};
    row.unoffered = how;
    return row;
}
inline constexpr auto accepted = unoffered<Unoffered::accepted>;
inline constexpr auto ignored = unoffered<Unoffered::ignored>;
inline constexpr auto refused = unoffered<Unoffered::refused>;

/// A long option of POV-Ray.
inline constexpr OptionRow benchmark = [] {
    OptionRow row{"", "", "benchmark", "", nothing, "there is no scene of its own to measure"};
    row.unoffered = Unoffered::ignored;
    return row;
}();

inline constexpr auto rows = std::to_array<OptionRow>({
    accepted("D", "Display", sign_and_value, "", "accepted without effect: no preview is shown"),
    accepted("P", "Pause_When_Done", sign, "", "accepted without effect"),
    accepted("HR", "High_Reproducibility", sign, "", "pictures are always reproducible"),
    ignored("BS", "Render_Block_Size", value, "n", order),
    ignored("RP", "Render_Pattern", value, "n", order),
    ignored("RS", "Render_Block_Step", value, "n", order),
    ignored("SP", "Preview_Start_Size", value, "n", no_preview),
    ignored("EP", "Preview_End_Size", value, "n", no_preview),
    accepted("X", "Test_Abort", sign_and_value, "n", "accepted without effect: Ctrl-C stops"),
    accepted("", "Test_Abort_Count", value, "n", "accepted without effect: Ctrl-C stops"),
    ignored("MB", "Bounding", sign_and_value, "n", index),
    ignored("", "Bounding_Threshold", value, "n", index),
    ignored("BM", "Bounding_Method", value, "n", index),
    ignored("UR", "Remove_Bounds", sign, "", index),
    ignored("SU", "Split_Unions", sign, "", index),
    ignored("UL", "Light_Buffer", sign, "", index),
    ignored("UV", "Vista_Buffer", sign, "", index),
    ignored("RVP", "Radiosity_Vain_Pretrace", sign, "", no_radiosity),
    ignored("MI", "Max_Image_Buffer_Memory", value, "n",
            "pictures are kept in memory; --memory limits all of it"),
    ignored("SS", "Stochastic_Seed", value, "n", "see --seed"),
    ignored("AC", "Antialias_Confidence", value, "n", "see --noise"),
    ignored("", "Histogram_Name", value, "file", older),
    ignored("", "Histogram_Type", value, "x", older),
    ignored("", "Histogram_Grid_Size", value, "n", older),
    ignored("", "Buffer_Output", value, "x", older),
    ignored("", "Buffer_Size", value, "n", older),
    ignored("", "Video_Mode", value, "x", older),
    ignored("", "Palette", value, "x", older),
    ignored("", "Draw_Vistas", value, "x", older),
    ignored("", "Real_Time_Raytracing", value, "x", older),
    ignored("", "Clockless_Animation", value, "x", older),
    ignored("", "Compression", value, "n", "each format is compressed in its usual way"),
    ignored("", "Display_Gamma", value, "g", no_preview),
    ignored("", "User_Abort_Return", value, "action", over),
    ignored("", "Fatal_Error_Return", value, "action", over),
    ignored("CC", "Create_Continue_Trace_Log", sign, "", "states are always kept; see STATES"),
    ignored("", "Continue_Trace_Log", value, "file", "states have names of their own; see STATES"),
    benchmark,
    refused("TH", "Dither", sign_and_value, "x",
            "pictures are not dithered; 16 bits have no steps that are seen: +FN16"),
    refused("", "Dither_Method", value, "x", "pictures are not dithered"),
    refused("UF", "Field_Render", sign, "", "no screen has interlaced fields any more"),
    refused("UO", "Odd_Field", sign, "", "no screen has interlaced fields any more"),
    refused("RF", "Radiosity_File_Name", value, "file", no_radiosity),
    refused("RFI", "Radiosity_From_File", sign, "", no_radiosity),
    refused("RFO", "Radiosity_To_File", sign, "", no_radiosity),
});

}  // namespace candelabra::povray_options
