// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_table.h"

#include "app/choice_options.h"
#include "app/console_options.h"
#include "app/film_options.h"
#include "app/limit_options.h"
#include "app/option_values.h"
#include "app/production_options.h"
#include "text/message.h"

#include <array>

namespace candelabra {

namespace {

using enum Takes;
using enum Changes;

constexpr std::string_view no_radiosity = "radiosity has no cache";
constexpr std::string_view no_preview = "no preview is shown";
constexpr std::string_view order =
    "tiles are made in their own order, all of them better and better";
constexpr std::string_view older = "it changes nothing in a picture";
constexpr std::string_view over = "the run has ended then";
constexpr std::string_view index = "objects are always found through an index; see --index";

using Store = void (*)(Options&, const Given&, Diagnostics&);
using Values = std::vector<std::string> (*)(const Options&);
using Term = std::string_view;

/// Returns a row whose value is stored in the setting with that name and documented by it.
constexpr OptionRow setting(Changes changes, Term letters, Term keyword, Term word, Term field) {
    return {letters, keyword, word, "n", value, {}, changes, field};
}

/// Returns a row for a setting that is on or off.
constexpr OptionRow option_field(Changes changes, Term letters, Term keyword, Term word,
                                 Takes takes, Term field) {
    return {letters, keyword, word, "", takes, {}, changes, field};
}

/// Returns a row for a switch that may be followed by a number, stored in the next setting.
constexpr OptionRow switched(Changes changes, Term letters, Term keyword, Term parameter,
                             Term field) {
    return {letters, keyword, "", parameter, sign_and_value, {}, changes, field};
}

/// `values`: what is in force, of an option that changes something.
constexpr OptionRow option(Changes changes, Term letters, Term keyword, Term word, Takes takes,
                           Term parameter, Store store, Term help, Values values = nullptr) {
    return {letters, keyword, word, parameter, takes, help, changes, {}, store, values};
}

template <Unoffered how>
constexpr OptionRow unoffered(Term letters, Term keyword, Takes takes, Term name, Term help) {
    OptionRow row{letters, keyword, {}, name, takes, help};
    row.unoffered = how;
    return row;
}
constexpr auto accepted = unoffered<Unoffered::accepted>;
constexpr auto ignored = unoffered<Unoffered::ignored>;
constexpr auto refused = unoffered<Unoffered::refused>;

constexpr OptionRow that(Touches touches, OptionRow row) {
    row.touches = touches;
    return row;
}

/// A long option of POV-Ray.
constexpr OptionRow benchmark = [] {
    OptionRow row{"", "", "benchmark", "", nothing, "there is no scene of its own to measure"};
    row.unoffered = Unoffered::ignored;
    return row;
}();

template <Stream which>
constexpr OptionRow stream(Term letters, Term keyword, Term help) {
    return that(Touches::writes, option(none, letters, keyword, "", sign_and_value, "file",
                                        store::stream_switch<which>, help));
}

template <Stream which>
constexpr OptionRow stream_file(Term keyword) {
    return that(Touches::writes, option(none, "", keyword, "", value, "file",
                                        store::stream_file<which>, "its file, or off"));
}

template <Moment moment>
constexpr OptionRow command(Term keyword, Term help) {
    return option(none, "", keyword, "", value, "command", store::command<moment>, help);
}

template <Moment moment>
constexpr OptionRow command_return(Term keyword) {
    return option(
        none, "", keyword, "", value, "action", store::command_return<moment>,
        "what comes of its failure: I nothing, S the picture is skipped, A all are, Q the "
        "run ends, U it is aborted, F it fails; -S and so on: of its success");
}

constexpr auto rows = std::to_array<OptionRow>({
    that(Touches::reads,
         option(none, "I", "Input_File_Name", "", value, "file", store::scene,
                "scene to read; - for standard input; a bare file name does the same")),
    that(Touches::writes,
         option(
             format, "O", "Output_File_Name", "output", value, "file", store::output,
             "picture to write; a folder keeps the scene's name; - for standard output; the ending "
             "says the format where +F does not")),
    option(format, "F", "Output_to_File", "", sign_and_value, "x", store::to_file,
           "format: N png (N16: 16 bits a channel), E OpenEXR and H Radiance HDR (linear), P ppm, "
           "T tga, C compressed tga, J jpeg, B bmp, I tiff (I16), W webp; -F writes no file",
           in_force::type),
    option(format, "", "Output_File_Type", "", value, "x", store::type, "the same format letters"),
    option(format, "", "Bits_Per_Color", "", value, "n", store::bits, "8 or 16 (png, tiff)",
           in_force::bits),
    option(format, "", "Grayscale_Output", "", sign, "", store::grey,
           "one channel of grey (png and tiff of 16 bits, ppm); +FNg does the same", in_force::grey),
    option(picture, "UA", "Output_Alpha", "", sign, "", store::alpha,
           "an alpha channel: how opaque a pixel is (png, tga, OpenEXR); clear is what lies behind "
           "everything, unless a background or a sky_sphere that is not transparent is there",
           in_force::alpha),
    setting(picture, "W", "Width", "", "width"),
    setting(picture, "H", "Height", "", "height"),
    switched(picture, "A", "Antialias", "t", "antialias"),
    setting(adaptive, "", "Antialias_Threshold", "", "antialias_threshold"),
    setting(adaptive, "AM", "Sampling_Method", "", "sampling_method"),
    setting(adaptive, "R", "Antialias_Depth", "", "antialias_depth"),
    setting(adaptive, "AG", "Antialias_Gamma", "", "antialias_gamma"),
    switched(adaptive, "J", "Jitter", "a", "jitter"),
    setting(adaptive, "", "Jitter_Amount", "", "jitter_amount"),
    setting(samples, "", "", "samples", "samples"),
    setting(samples, "", "", "noise", "noise"),
    option(samples, "", "", "time", value, "duration", store::time,
           "finishes the picture as it is after this time (90s, 10m, 2h); the one option that "
           "makes a picture depend on the machine",
           in_force::time),
    setting(picture, "", "", "shadow-rays", "shadow_rays"),
    option(none, "", "", "light-report", nothing, "", store::light_report,
           "says at the end what the lights of each statement gave and what they cost"),
    option(picture, "", "", "layers", value, "names", store::layers,
           "layers beside the colours, with commas between: albedo, normal, depth, object, lights "
           "(one for each statement that makes lights), variance, samples, shadow_rays, or all; in "
           "the picture if that is OpenEXR, otherwise in a file .layers.exr beside it; see LAYERS",
           in_force::layers),
    option(picture, "SR", "Start_Row", "", value, "n", store::start_row,
           "first row that is rendered, from 1; below 1 a fraction; the picture is black elsewhere",
           in_force::start_row),
    option(picture, "ER", "End_Row", "", value, "n", store::end_row,
           "last row that is rendered; up to 1 a fraction", in_force::end_row),
    option(picture, "SC", "Start_Column", "", value, "n", store::start_column,
           "first column that is rendered", in_force::start_column),
    option(picture, "EC", "End_Column", "", value, "n", store::end_column,
           "last column that is rendered", in_force::end_column),
    option(none, "C", "Continue_Trace", "", sign, "", store::go_on,
           "goes on from the state that an earlier run has left beside the picture; see STATES"),
    option(none, "", "", "checkpoint", value, "duration", store::checkpoint,
           "time between two states while a picture is made (60s); 0: only on signals"),
    option(none, "", "", "keep-state", nothing, "", store::keep_state,
           "keeps the state of a finished picture, so that +C can add samples"),
    option(none, "", "", "shard", value, "i/n", store::shard,
           "makes one of n parts, for merge; auto: as the job array of Slurm or AWS Batch says, "
           "auto/n with Kubernetes; see FARMS"),
    option(none, "", "", "shard-by", value, "what", store::shard_by,
           "parts are samples (the default), tiles, or frames (the default of animations)"),
    option(picture, "", "", "light-sampler", value, "name", store::sampler,
           "way to choose luminaires, instead of the scene's; see LIGHT SAMPLERS",
           in_force::sampler),
    option(none, "", "", "index", value, "name", store::index,
           "what finds the surfaces that rays meet, instead of the scene's: kd_tree or "
           "bounding_boxes; pictures are the same"),
    option(picture, "", "", "integrator", value, "name", store::integrator,
           "how light is followed, instead of the scene's: pov_ray or path_traced; see "
           "INTEGRATORS",
           in_force::integrator),
    option(picture, "", "", "denoise", nothing, "", store::denoise,
           "makes a picture with less noise beside the exact one, a.denoised.png with a.png, or "
           "the layer denoised in an OpenEXR file; see NOISE AND TIME",
           in_force::denoise),
    option(picture, "", "", "film", value, "on|off", store::film<"film">,
           "a film as in camera { film { } }, which the scene may describe; off: none; see FILM",
           in_force::film<"film">),
    option(picture, "", "", "exposure", value, "stops", store::film<"exposure">,
           "of the film: stops that double the light each, or auto, or auto+1",
           in_force::film<"exposure">),
    option(picture, "", "", "key", value, "luminance", store::film<"key">,
           "of the film: what an automatic exposure makes of the whole picture; 0.18 unless given",
           in_force::film<"key">),
    option(picture, "", "", "white-balance", value, "kelvins", store::film<"white_balance">,
           "of the film: light of a black body so hot becomes white; 0: colours stay",
           in_force::film<"white_balance">),
    option(picture, "", "", "response", value, "name", store::film<"response">,
           "of the film: linear, filmic or agx", in_force::film<"response">),
    option(picture, "", "", "contrast", value, "exponent", store::film<"contrast">,
           "of the film: of the light around a middle grey", in_force::film<"contrast">),
    option(picture, "", "", "saturation", value, "factor", store::film<"saturation">,
           "of the film: on the distance of colours from grey", in_force::film<"saturation">),
    option(picture, "", "", "pixel-filter", value, "name", store::film<"pixel_filter">,
           "of the film: box, triangle, mitchell or blackman_harris",
           in_force::film<"pixel_filter">),
    option(picture, "", "", "smooth-edges", value, "on|off", store::film<"smooth_edges">,
           "of the film: samples are compressed before they are averaged",
           in_force::film<"smooth_edges">),
    option(picture, "", "", "glare", value, "what", store::glare,
           "of the film: on, off, or fields such as veil=0.2,star=0.05,blades=6", in_force::glare),
    option(picture, "", "", "vignette", value, "share", store::film<"vignette">,
           "of the film: light that corners lose", in_force::film<"vignette">),
    option(picture, "", "", "grain", value, "size", store::film<"grain">,
           "of the film: size of its grains", in_force::film<"grain">),
    setting(picture, "", "", "seed", "seed"),
    setting(none, "WT", "Work_Threads", "threads", "threads"),
    that(Touches::reads, option(folders, "L", "Library_Path", "", value, "folder", store::library,
                                "folder to look for included files in; may be given several times",
                                in_force::library)),
    that(Touches::permits,
         option(none, "", "", "allow-read", value, "folder", store::allow_read,
                "folder below which the scene may read, too; may be given several times")),
    that(Touches::permits,
         option(none, "", "", "allow-write", value, "folder", store::allow_write,
                "folder below which the scene may write, too; may be given several times")),
    that(Touches::permits,
         option(none, "", "", "sandbox", value, "on|off", store::sandbox,
                "whether the program confines itself to the files and system calls that the run "
                "needs; on where the system can do that (Linux's Landlock and seccomp), off with "
                "--allow-commands")),
    option(none, "", "", "limit-steps", value, "n", store::limit_steps,
           "how many passes of loops and calls of macros a scene may take (100 million)"),
    option(none, "", "", "limit-depth", value, "n", store::limit_depth,
           "how many calls of macros may be open inside each other (200,000)"),
    option(none, "", "", "limit-nesting", value, "n", store::limit_nesting,
           "how many objects may be inside each other (10,000)"),
    option(none, "", "", "limit-objects", value, "n", store::limit_objects,
           "how many objects a scene may make, parts of unions included (20 million)"),
    option(none, "", "", "limit-includes", value, "n", store::limit_includes,
           "how many included files may be open inside each other (100)"),
    option(none, "", "", "limit-files", value, "n", store::limit_files,
           "how often a scene may include or open files, each time counted (100,000)"),
    option(none, "", "", "limit-elements", value, "n", store::limit_elements,
           "how many elements an array may have (100 million)"),
    option(none, "", "", "limit-written", value, "MB", store::limit_written,
           "how much the scene may write with #write, in megabytes (1024)"),
    option(none, "", "", "limit-said", value, "MB", store::limit_said,
           "how much the scene may say with #debug and its relatives, in megabytes (64)"),
    option(none, "", "", "limit-text", value, "MB", store::limit_text,
           "how long a string may be, in megabytes (64)"),
    option(none, "", "", "limit-function", value, "n", store::limit_function,
           "how many steps a call of a function may take, its loops run once (10 million)"),
    option(none, "", "", "limit-work", value, "n", store::limit_work,
           "how many steps of any kind a scene may take before it is rendered, in millions (4000)"),
    option(none, "", "", "limit-memory", value, "MB", store::limit_memory,
           "how much memory the run may take, in megabytes (half of what is free at the start)"),
    option(none, "", "", "memory", value, "size", store::memory, "the same as 500M or 8G"),
    option(picture, "", "Declare", "", value, "name=value", store::declare,
           "declares a name for the scene: a number, or a string in quotes", in_force::declares),
    option(picture, "K", "Clock", "", value, "n", store::clock, "value of clock in the scene",
           in_force::clock),
    setting(picture, "KFI", "Initial_Frame", "", "initial_frame"),
    setting(picture, "KFF", "Final_Frame", "", "final_frame"),
    setting(picture, "KI", "Initial_Clock", "", "initial_clock"),
    setting(picture, "KF", "Final_Clock", "", "final_clock"),
    setting(none, "SF", "Subset_Start_Frame", "", "subset_start_frame"),
    setting(none, "EF", "Subset_End_Frame", "", "subset_end_frame"),
    setting(none, "STP", "Frame_Step", "", "frame_step"),
    option(none, "", "", "frames", value, "list", store::frames,
           "frames that are rendered, in this order: 3,7,12-20,9-5"),
    option_field(picture, "KC", "Cyclic_Animation", "", sign, "cyclic_animation"),
    option_field(none, "", "", "skip-existing", nothing, "skip_existing"),
    that(Touches::writes, option(none, "", "", "movie", value, "file", store::movie,
                                 "makes a film of all frames with ffmpeg, when they are done; the "
                                 "ending says which kind")),
    option(none, "", "", "frame-rate", value, "n", store::frame_rate,
           "frames a second in the film (25)"),
    that(Touches::searches,
         option(folders, "HI", "Include_Header", "", value, "file", store::header,
                "file that is included before the scene", in_force::header)),
    option(picture, "MV", "Version", "", value, "n", store::language_version,
           "version of the language until the scene says one", in_force::version),
    option(none, "", "Include_Ini", "", value, "file", store::include_ini,
           "reads another INI file"),
    that(Touches::writes_ini, option(none, "GI", "", "", sign_and_value, "file", store::create_ini,
                                     "writes all options in force to an INI file")),
    that(Touches::writes_ini, option(none, "", "Create_Ini", "", value, "file", store::create_ini,
                                     "the same; off: none")),
    option(
        none, "V", "Verbose", "", sign, "", store::verbose,
        "progress and a summary (the default); -V: only warnings, errors and what the scene says"),
    that(Touches::writes,
         option(none, "GA", "All_Console", "", sign_and_value, "file", store::all_streams,
                "all that is said appears (the default), and goes to a file, too; -GA: nothing "
                "appears")),
    that(Touches::writes, option(none, "", "All_File", "", value, "file", store::all_stream_files,
                                 "all that is said goes to a file, too")),
    stream<Stream::debug>("GD", "Debug_Console", "the same for what the scene says"),
    stream_file<Stream::debug>("Debug_File"),
    stream<Stream::fatal>("GF", "Fatal_Console", "the same for errors"),
    stream_file<Stream::fatal>("Fatal_File"),
    stream<Stream::render>("GR", "Render_Console", "the same for progress"),
    stream_file<Stream::render>("Render_File"),
    stream<Stream::statistics>("GS", "Statistic_Console", "the same for the summary"),
    stream_file<Stream::statistics>("Statistic_File"),
    stream<Stream::warning>("GW", "Warning_Console", "the same for warnings"),
    stream_file<Stream::warning>("Warning_File"),
    that(Touches::permits,
         option(none, "", "", "allow-commands", nothing, "", store::allow_commands,
                "runs the commands of the following options, which are left out otherwise; no INI "
                "file that may come with a scene can say this or the two other permissions")),
    command<Moment::pre_scene>("Pre_Scene_Command", "before everything"),
    command_return<Moment::pre_scene>("Pre_Scene_Return"),
    command<Moment::pre_frame>("Pre_Frame_Command", "before each picture"),
    command_return<Moment::pre_frame>("Pre_Frame_Return"),
    command<Moment::post_frame>("Post_Frame_Command", "after each picture"),
    command_return<Moment::post_frame>("Post_Frame_Return"),
    command<Moment::post_scene>("Post_Scene_Command", "after everything"),
    command_return<Moment::post_scene>("Post_Scene_Return"),
    command<Moment::user_abort>("User_Abort_Command", "after a signal has ended the work"),
    command<Moment::fatal_error>("Fatal_Error_Command", "after an error"),
    option(none, "", "", "warn", value, "names", store::warn,
           "warnings by name, with commas between: `no-division-by-zero` switches one off, `none` "
           "and `all` do what they say, `error` makes warnings errors; see WARNINGS"),
    option(none, "WL", "Warning_Level", "", value, "n", store::warning_level,
           "0: no warnings; anything else: all"),
    option(none, "", "", "diagnostics", value, "form", store::diagnostics,
           "text (the default) or json: an object on a line for each message, and nothing else on "
           "the error stream"),
    option(none, "", "", "check", maybe_value, "syntax", store::check,
           "evaluates the scene and says what is wrong, without rendering; with --stats it also "
           "builds what rays need; =syntax: reads the scene, but does not evaluate it"),
    option(
        none, "", "", "dump", value, "stage", store::dump,
        "prints what the scene is at a stage: tokens, tree, scene, world, or index (a drawing in "
        "SVG of the cells that a slice cuts)"),
    that(
        Touches::writes,
        option(none, "", "", "export-mesh", value, "file", store::export_mesh,
               "writes the scene's surfaces as triangles to a file, PLY or OBJ by its ending, and "
               "renders nothing; shapes are taken apart, intersections and differences are exact")),
    option(none, "", "", "export-object", value, "name", store::export_object,
           "what --export-mesh writes: a declared object in the place of the whole scene"),
    option(none, "", "", "progress", value, "form", store::progress,
           "auto (the default), plain lines, none; or for programs: json on the error stream, alf "
           "(of RenderMan's queues) or openjd (Open Job Description) on the standard output"),
    that(Touches::permits, option(none, "", "", "preview", value, "port", store::preview,
                                  "shows the picture at http://localhost:PORT/ while it becomes "
                                  "better, and makes it anew "
                                  "when the scene changes; 0: any free port")),
    that(
        Touches::writes,
        option(none, "", "", "depfile", value, "file", store::depfile,
               "writes a rule for make(1) with all files that the picture was made from; of frames "
               "each has "
               "its own, with a number")),
    that(Touches::writes,
         option(
             none, "", "", "stats", value, "file", store::stats,
             "writes what the run cost as JSON; - for standard output; of frames each has its own, "
             "with a "
             "number")),
    option(none, "", "", "help", maybe_words, "topic", store::help,
           "this text, or what there is to say about an option, an item or a group of items"),
    option(none, "", "", "version", nothing, "", store::version, "name and version"),
    option(none, "", "", "describe", maybe_words, "form part", store::describe,
           "options and vocabulary as text, roff or json; part: items, functions, glossary, "
           "library, macros, options, compatibility, missing, words, warnings or textmate (a "
           "grammar)"),
    option(none, "", "", "completion", value, "shell", store::completion,
           "prints what completes options in bash, zsh or fish"),
    accepted("D", "Display", sign_and_value, "", "accepted without effect: no preview is shown"),
    accepted("P", "Pause_When_Done", sign, "", "accepted without effect"),
    setting(picture, "Q", "Quality", "", "quality"),
    option(picture, "", "", "luminaires", value, "n", store::luminaires,
           "which of the things that glow light others, instead of the scene's rule: those with a "
           "radiance above n, or none",
           in_force::luminaires),
    option_field(picture, "", "", "ambient-luminaires", nothing, "ambient_luminaires"),
    option(picture, "", "File_Gamma", "", value, "g", store::gamma,
           "how pictures of whole "
           "numbers are encoded: sRGB (the default), bt709, bt2020, or a power of which this is "
           "the inverse; "
           "OpenEXR and Radiance HDR are linear",
           in_force::gamma),
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

}  // namespace

std::span<const OptionRow> option_table() { return rows; }

void apply(const OptionRow& row, Options& options, const Given& given, Diagnostics& diagnostics) {
    const std::string why = row.help.empty() ? "" : message(": ", row.help);
    switch (row.unoffered) {
        case Unoffered::no:
            break;
        case Unoffered::accepted:
            return;
        case Unoffered::ignored:
            diagnostics.add(warning(Fault::option, {}, message(shown(given), " is ignored", why)));
            return;
        case Unoffered::refused:
            if (given.on) refuse(given, diagnostics, message("is not offered", why));
            return;
    }
    if (row.store)
        row.store(options, given, diagnostics);
    else
        store::field(row.field, options, given, diagnostics);
}

}  // namespace candelabra
