// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_table.h"

#include "options/choice_options.h"
#include "options/console_options.h"
#include "options/film_options.h"
#include "options/option_rows.h"
#include "options/option_values.h"
#include "options/povray_options.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

using namespace option_rows;
using Type = OptionField::Type;

constexpr double megabyte = 1 << 20, million = 1e6;

// The names of choices stand in the order of their values.
constexpr std::array<std::string_view, 3> parts_of_work = {"samples", "tiles", "frames"};
constexpr std::array<std::string_view, 2> off_or_on = {"off", "on"};
constexpr std::array<std::string_view, 2> diagnostic_forms = {"text", "json"};
constexpr std::array<std::string_view, 7> progress_forms = {"auto",   "plain",  "json", "alf",
                                                            "openjd", "povray", "none"};

void room_for_depth(Options& options) { options.limits.make_room(); }

/// The language counts elements in 32 bits.
void countable_elements(Options& options) {
    constexpr std::size_t most = 2'000'000'000;
    options.limits.array_elements = std::min(options.limits.array_elements, most);
}

/// The table with its groups' beginnings. Commands that pictures record have options in this order.
constexpr auto listed = std::to_array<OptionRow>({
    begin(OptionGroup::picture),
    that(Touches::reads,
         option(
             none, "I", "Input_File_Name", "", value, "file", store::scene,
             "scene file; - reads standard input; a file name without an option is a scene, too")),
    basic(that(Touches::writes,
               option(format, "O", "Output_File_Name", "output", value, "file",
                      kept<&Options::output>(Type::text),
                      "picture file, or a folder for a picture named after the scene; - writes to "
                      "standard output; its ending sets the format unless +F is given",
                      in_force::unsaid))),
    option(format, "F", "Output_to_File", "", sign_and_value, "x", store::to_file,
           "picture format: N png (N16: 16 bits per channel), E OpenEXR and H Radiance HDR (both "
           "linear), P ppm, T tga, C compressed tga, J jpeg, B bmp, I tiff (I16: 16 bits), W webp; "
           "-F writes no picture",
           in_force::type),
    option(format, "", "Output_File_Type", "", value, "x", store::type,
           "picture format by one letter: N png, E OpenEXR, H Radiance HDR, P ppm, T tga, C "
           "compressed tga, J jpeg, B bmp, I tiff, W webp"),
    option(format, "", "Bits_Per_Color", "", value, "n", store::bits,
           "bits per channel in png and tiff pictures: 8 or 16", in_force::bits),
    option(format, "", "Grayscale_Output", "", sign, "", kept<&Options::grey>(Type::toggle),
           "writes a greyscale picture (16-bit png or tiff, or ppm), like +FNg"),
    option(picture, "UA", "Output_Alpha", "", sign, "", kept<&Options::alpha>(Type::toggle),
           "adds an alpha channel with the opacity of each pixel (png, tga, OpenEXR); empty space "
           "is transparent unless an opaque background or sky_sphere fills it"),
    basic(setting(picture, "W", "Width", "", "width")),
    basic(setting(picture, "H", "Height", "", "height")),

    begin(OptionGroup::quality),
    basic(switched(picture, "A", "Antialias", "t", "antialias")),
    setting(adaptive, "", "Antialias_Threshold", "", "antialias_threshold"),
    setting(adaptive, "AM", "Sampling_Method", "", "sampling_method"),
    setting(adaptive, "R", "Antialias_Depth", "", "antialias_depth"),
    setting(adaptive, "AG", "Antialias_Gamma", "", "antialias_gamma"),
    switched(adaptive, "J", "Jitter", "a", "jitter"),
    setting(adaptive, "", "Jitter_Amount", "", "jitter_amount"),
    basic(setting(samples, "", "", "samples", "samples")),
    basic(setting(samples, "", "", "noise", "noise")),
    basic(option(samples, "", "", "time", value, "duration",
                 kept<&Options::time>(Type::duration, above(0)),
                 "time limit (90s, 10m, 2h), after which the picture is written as it is; the only "
                 "option that makes pictures depend on the machine")),
    setting(picture, "", "", "shadow-rays", "shadow_rays"),

    begin(OptionGroup::picture),
    option(picture, "", "", "layers", value, "names", store::layers,
           "extra layers, separated by commas: albedo, normal, depth, object, lights (one for each "
           "statement that makes lights), variance, samples, shadow_rays, or all; stored in the "
           "picture if it is OpenEXR, otherwise in a file .layers.exr beside it; see LAYERS",
           in_force::layers),
    that(Touches::writes,
         option(none, "", "", "keep-lights", value, "file", kept<&Options::kept_lights>(Type::text),
                "keeps the light of each lamp in a file, from which candelabra relight makes the "
                "picture under any powers and colours of the lamps")),
    option(none, "", "", "keep-lights-size", value, "size",
           kept<&Options::kept_lights_bytes>(Type::size, between(0x1p16, 0x1p40)),
           "largest file of --keep-lights, such as 300M; the usual one has about 150 bytes a "
           "pixel, but at least 16M"),
    option(picture, "SR", "Start_Row", "", value, "n",
           kept<&Options::start_row>(Type::number, at_least(0)),
           "first row to render, counted from 1; below 1: a fraction of the height; rows outside "
           "of the range are black",
           in_force::start_row),
    option(picture, "ER", "End_Row", "", value, "n",
           kept<&Options::end_row>(Type::number, at_least(0)),
           "last row to render; up to 1: a fraction of the height", in_force::end_row),
    option(picture, "SC", "Start_Column", "", value, "n",
           kept<&Options::start_column>(Type::number, at_least(0)),
           "first column to render, counted from 1; below 1: a fraction of the width",
           in_force::start_column),
    option(picture, "EC", "End_Column", "", value, "n",
           kept<&Options::end_column>(Type::number, at_least(0)),
           "last column to render; up to 1: a fraction of the width", in_force::end_column),

    begin(OptionGroup::quality),
    basic(setting(none, "WT", "Work_Threads", "threads", "threads")),

    begin(OptionGroup::light),
    basic(option(picture, "", "", "light-sampler", value, "name", store::sampler,
                 "light sampler, in place of the scene's; see LIGHT SAMPLERS", in_force::sampler)),
    option(picture, "", "", "integrator", value, "name", store::integrator,
           "integrator, in place of the scene's: pov_ray or path_traced; see INTEGRATORS",
           in_force::integrator),

    begin(OptionGroup::quality),
    basic(option(picture, "", "", "denoise", nothing, "", kept<&Options::denoise>(Type::toggle),
                 "writes a denoised picture beside the exact one; a.denoised.png, or the layer "
                 "denoised in an OpenEXR file; see NOISE AND TIME")),
    basic(option(picture, "", "", "draft", nothing, "", kept<&Options::draft>(Type::toggle),
                 "quick denoised picture a.draft.png instead of a.png; 4 samples per pixel unless "
                 "--samples is given")),

    begin(OptionGroup::light),
    option(none, "", "", "index", value, "name", store::index,
           "index that finds the surfaces along a ray, in place of the scene's: kd_tree or "
           "bounding_boxes; it does not change pictures"),
    option(none, "", "", "light-report", nothing, "", kept<&Options::light_report>(Type::toggle),
           "prints a table of the light and the cost of each statement that makes lights; with "
           "--layers lights it also names statements that could be off unseen, and with "
           "--keep-lights single lamps"),

    begin(OptionGroup::film),
    option(picture, "", "", "film", value, "on|off", store::film<"film">,
           "turns the scene's film, or a standard one, on or off; see FILM",
           in_force::film<"film">),
    option(picture, "", "", "exposure", value, "stops", store::film<"exposure">,
           "exposure of the film in stops (each doubles the light), auto, or auto with a "
           "correction such as auto+1",
           in_force::film<"exposure">),
    option(picture, "", "", "key", value, "luminance", store::film<"key">,
           "luminance that automatic exposure gives to the whole picture; default 0.18",
           in_force::film<"key">),
    option(picture, "", "", "white-balance", value, "kelvins", store::film<"white_balance">,
           "colour temperature of the light that the film shows as white, in kelvins; 0: no "
           "correction",
           in_force::film<"white_balance">),
    option(picture, "", "", "response", value, "name", store::film<"response">,
           "response curve of the film: linear, filmic or agx", in_force::film<"response">),
    option(picture, "", "", "contrast", value, "exponent", store::film<"contrast">,
           "contrast of the film around middle grey: an exponent, 1 for no change",
           in_force::film<"contrast">),
    option(picture, "", "", "saturation", value, "factor", store::film<"saturation">,
           "saturation of the film: 0 grey, 1 no change", in_force::film<"saturation">),
    option(picture, "", "", "pixel-filter", value, "name", store::film<"pixel_filter">,
           "pixel filter of the film: box, triangle, mitchell or blackman_harris",
           in_force::film<"pixel_filter">),
    option(picture, "", "", "smooth-edges", value, "on|off", store::film<"smooth_edges">,
           "smooth edges of very bright areas: samples are compressed before they are averaged",
           in_force::film<"smooth_edges">),
    option(picture, "", "", "glare", value, "what", store::glare,
           "glare of the lens: on, off, or settings such as veil=0.2,star=0.05,blades=6",
           in_force::glare),
    option(picture, "", "", "vignette", value, "share", store::film<"vignette">,
           "share of the light that the corners of the film lose", in_force::film<"vignette">),
    option(picture, "", "", "grain", value, "size", store::film<"grain">,
           "size of the film's grain", in_force::film<"grain">),

    begin(OptionGroup::quality),
    setting(picture, "", "", "seed", "seed"),

    begin(OptionGroup::scene),
    basic(that(Touches::reads,
               option(folders, "L", "Library_Path", "", value, "folder",
                      kept<&Options::library_paths>(Type::list),
                      "folder to search for included files; may be repeated", in_force::library))),
    that(Touches::reads,
         option(folders, "", "", "library", value, "folder", kept<&Options::libraries>(Type::list),
                "folder of include files, such as POV-Ray's, to search before the standard "
                "library; may be repeated",
                in_force::first_libraries)),
    option(picture, "", "Declare", "", value, "name=value", store::declare,
           "declares a variable of the scene: a number, or a string in quotes", in_force::declares),
    that(Touches::reads,
         option(none, "", "", "preset", value, "file", store::preset,
                "declares the names of a JSON file, such as the preview saves, with their values")),
    option(picture, "K", "Clock", "", value, "n", store::clock,
           "value of the scene's variable clock", in_force::clock),

    begin(OptionGroup::animation),
    setting(picture, "KFI", "Initial_Frame", "", "initial_frame"),
    setting(picture, "KFF", "Final_Frame", "", "final_frame"),
    setting(picture, "KI", "Initial_Clock", "", "initial_clock"),
    setting(picture, "KF", "Final_Clock", "", "final_clock"),
    setting(none, "SF", "Subset_Start_Frame", "", "subset_start_frame"),
    setting(none, "EF", "Subset_End_Frame", "", "subset_end_frame"),
    setting(none, "STP", "Frame_Step", "", "frame_step"),
    option(none, "", "", "frames", value, "list", store::frames,
           "frames to render, in the given order: 3,7,12-20,9-5"),
    option_field(picture, "KC", "Cyclic_Animation", "", sign, "cyclic_animation"),

    begin(OptionGroup::scene),
    that(Touches::searches,
         option(folders, "HI", "Include_Header", "", value, "file", store::header,
                "file to include before the scene", in_force::header)),
    option(picture, "MV", "Version", "language-version", value, "n",
           kept<&Options::facts, &RunFacts::version>(Type::number, at_least(1)),
           "language version until the scene sets one with #version"),

    begin(OptionGroup::quality),
    setting(picture, "Q", "Quality", "", "quality"),

    begin(OptionGroup::light),
    option(picture, "", "", "luminaires", value, "n", store::luminaires,
           "lowest radiance at which a glowing object lights its surroundings, in place of the "
           "scene's rule; none: no glowing object does",
           in_force::luminaires),
    option_field(picture, "", "", "ambient-luminaires", nothing, "ambient_luminaires"),

    begin(OptionGroup::picture),
    option(picture, "", "File_Gamma", "", value, "g", store::gamma,
           "encoding of integer formats: sRGB (the default), bt709, bt2020, or a gamma such as "
           "2.2; OpenEXR and Radiance HDR are always linear",
           in_force::gamma),

    begin(OptionGroup::animation),
    option_field(none, "", "", "skip-existing", nothing, "skip_existing"),
    option(none, "", "", "sheet", value_and_settings, "NxM name=values",
           kept<&Options::sheet>(Type::text),
           "contact sheet of N columns and M rows: pictures side by side for values of a variable, "
           "such as 4x3 Seed=1..12, or of two, 4x3 Seed=1..4 Height=1,2,5; clock is one, too"),
    that(Touches::writes,
         option(none, "", "", "movie", value, "file", kept<&Options::movie>(Type::text),
                "joins all frames into a movie with ffmpeg at the end; the ending of its name sets "
                "the format")),
    option(none, "", "", "frame-rate", value, "n",
           kept<&Options::frame_rate>(Type::number, Range{0, 1000, true}),
           "frames per second in the movie of --movie"),

    begin(OptionGroup::states),
    basic(
        option(none, "C", "Continue_Trace", "", sign, "", kept<&Options::go_on>(Type::toggle),
               "continues from the state that an earlier run left beside the picture; see STATES")),
    option(none, "", "", "checkpoint", value, "duration",
           kept<&Options::checkpoint_interval>(Type::duration, between(0, 1e9)),
           "time between saved states while a picture is rendered; 0: saves only on signals"),
    option(none, "", "", "keep-state", nothing, "", kept<&Options::keep_state>(Type::toggle),
           "keeps the state of a finished picture, so that +C can add samples to it"),
    option(none, "", "", "shard", value, "i/n", kept<&Options::shard>(Type::text),
           "renders part i of n, which candelabra merge joins; auto: from the job array of Slurm "
           "or AWS Batch, auto/n with Kubernetes; see FARMS"),
    option(
        none, "", "", "shard-by", value, "what", one_of<&Options::shard_by>(parts_of_work),
        "unit of the parts of --shard; without it, frames of an animation or samples of a picture"),

    begin(OptionGroup::files),
    that(Touches::permits,
         option(none, "", "", "allow-read", value, "folder", kept<&Options::readable>(Type::list),
                "folder in which the scene may read files; may be repeated")),
    that(Touches::permits,
         option(none, "", "", "allow-write", value, "folder", kept<&Options::writable>(Type::list),
                "folder in which the scene may write files; may be repeated")),
    that(Touches::permits,
         option(none, "", "", "sandbox", value, "on|off", one_of<&Options::sandbox>(off_or_on),
                "confines the program to the files and system calls that a run needs; on where the "
                "system supports it (Landlock and seccomp of Linux), off with --allow-commands")),
    option(none, "", "Include_Ini", "", value, "file", store::include_ini,
           "INI file with more options"),
    that(Touches::writes_ini, option(none, "GI", "", "", sign_and_value, "file", store::create_ini,
                                     "writes all current options to an INI file")),
    that(Touches::writes_ini, option(none, "", "Create_Ini", "", value, "file", store::create_ini,
                                     "INI file to write all current options to; off: none")),
    that(Touches::writes,
         option(none, "", "", "depfile", value, "file", kept<&Options::depfile>(Type::text),
                "writes a make(1) rule with all files that the picture depends on; each frame of "
                "an animation has its own numbered file")),

    begin(OptionGroup::limits),
    limit("limit-steps", "n", kept<&Options::limits, &Limits::steps>(Type::whole, between(1, 1e12)),
          "most loop passes and macro calls in a scene"),
    limit("limit-depth", "n",
          kept<&Options::limits, &Limits::call_depth>(Type::whole, between(1, 1e8)),
          "deepest nesting of macro calls", room_for_depth),
    limit("limit-nesting", "n",
          kept<&Options::limits, &Limits::nesting>(Type::whole, between(1, 1e8)),
          "deepest nesting of objects", room_for_depth),
    limit("limit-objects", "n",
          kept<&Options::limits, &Limits::objects>(Type::whole, between(1, 1e12)),
          "most objects in a scene, counting parts of unions"),
    limit("limit-includes", "n",
          kept<&Options::limits, &Limits::include_depth>(Type::whole, between(1, 1e12)),
          "deepest nesting of included files"),
    limit("limit-files", "n", kept<&Options::limits, &Limits::files>(Type::whole, between(1, 1e12)),
          "most times that a scene includes or opens a file"),
    limit("limit-elements", "n",
          kept<&Options::limits, &Limits::array_elements>(Type::whole, between(1, 1e12)),
          "most elements in an array", countable_elements),
    limit("limit-written", "MB",
          kept<&Options::limits, &Limits::written_bytes>(Type::whole, between(1, 1e12), megabyte),
          "most megabytes that a scene writes with #write"),
    limit("limit-said", "MB",
          kept<&Options::limits, &Limits::said_bytes>(Type::whole, between(1, 1e12), megabyte),
          "most megabytes of text that a scene prints with #debug, #warning and the like"),
    limit("limit-text", "MB",
          kept<&Options::limits, &Limits::text_bytes>(Type::whole, between(1, 1e12), megabyte),
          "longest string in megabytes"),
    limit("limit-function", "n",
          kept<&Options::limits, &Limits::function_steps>(Type::whole, between(1, 1e12)),
          "most steps in one call of a function, with each loop counted once"),
    limit("limit-work", "n",
          kept<&Options::limits, &Limits::work>(Type::whole, between(1, 1e12), million),
          "most millions of steps of any kind before rendering begins"),
    limit("limit-memory", "MB",
          kept<&Options::memory_bytes>(Type::whole, between(1, 1e12), megabyte),
          "most megabytes of memory for the run; default: half of the memory that is free at the "
          "start"),
    option(none, "", "", "memory", value, "size",
           kept<&Options::memory_bytes>(Type::size, between(0x1p20, 0x1p60)),
           "most memory for the run with a unit, such as 500M or 8G"),

    begin(OptionGroup::tasks),
    basic(option(none, "", "", "check", maybe_value, "syntax", store::check,
                 "checks the scene for errors without rendering; with --stats, it also builds the "
                 "index for rays; --check=syntax: parses the scene without evaluating it")),
    option(none, "", "", "dump", value, "stage", store::dump,
           "prints one stage of the scene: tokens, tree, scene, world, or index (an SVG drawing of "
           "a slice through its cells)"),
    option(none, "", "", "pick", value, "x,y", store::pick,
           "prints what is at a pixel, counted from 0 at the upper left, and which lamps light it"),
    that(Touches::writes,
         option(none, "", "", "export-mesh", value, "file", store::export_mesh,
                "writes the scene's surfaces as a triangle mesh, PLY or OBJ by the file's ending, "
                "without rendering; intersections and differences are exact")),
    that(Touches::writes,
         option(none, "", "", "measure", value, "file", store::measure,
                "measures the light at the scene's meters; CSV or JSON by the ending; see METERS")),
    that(Touches::writes,
         option(none, "", "", "light-balance", value, "file", store::light_balance,
                "follows the light of all lamps to its ends on surfaces, in the air and "
                "outside of the scene, in lumens; CSV or JSON by the ending")),
    option(none, "", "", "until", value, "error", store::until,
           "error at which --measure ends, such as 'lux 1%'; 2% of all without it"),
    option(none, "", "", "export-object", value, "name", kept<&Options::mesh_object>(Type::text),
           "name of the declared object that --export-mesh writes, in place of the whole scene"),
    basic(that(Touches::permits,
               option(none, "", "", "preview", value, "port", store::preview,
                      "shows the picture at http://localhost:PORT/ while it is rendered; renders "
                      "again when the scene changes; port 0: any free port"))),
    that(Touches::permits,
         option(none, "", "", "preview-host", value, "address",
                kept<&Options::preview_host>(Type::text),
                "address of this machine on which --preview serves other machines, such as "
                "192.168.1.7, or 0.0.0.0 for all; the printed address has a token, without which "
                "nobody is answered")),
    basic(option(none, "", "", "help", maybe_words, "topic", store::help,
                 "lists the usual options; --help all lists every option; with a word, explains an "
                 "option, an item or a group")),
    option(none, "", "", "version", nothing, "", store::version,
           "prints the program's name and version"),
    option(none, "", "", "describe", maybe_words, "form part", store::describe,
           "prints options and vocabulary as text, roff or json; part: items, functions, glossary, "
           "library, macros, options, compatibility, missing, words, warnings or textmate (a "
           "grammar)"),
    option(none, "", "", "completion", value, "shell", store::completion,
           "prints the completion script for bash, zsh or fish"),

    begin(OptionGroup::console),
    option(none, "V", "Verbose", "", sign, "", kept<&Options::verbose>(Type::toggle),
           "shows progress and a summary (the default); -V: only warnings, errors and the scene's "
           "own messages"),
    that(Touches::writes,
         option(none, "GA", "All_Console", "", sign_and_value, "file", store::all_streams,
                "shows all output on the console (the default), and also writes it to a file if "
                "one is named; -GA: a silent console")),
    that(Touches::writes, option(none, "", "All_File", "", value, "file", store::all_stream_files,
                                 "file for all output, besides the console; off: none")),
    stream<Stream::debug>("GD", "Debug_Console",
                          "shows the scene's own messages on the console (the default), and also "
                          "writes them to a file if one is named; -GD: not on the console"),
    stream_file<Stream::debug>("Debug_File",
                               "file for the scene's own messages, besides the console; off: none"),
    stream<Stream::fatal>("GF", "Fatal_Console",
                          "shows errors on the console (the default), and also writes them to a "
                          "file if one is named; -GF: not on the console"),
    stream_file<Stream::fatal>("Fatal_File", "file for errors, besides the console; off: none"),
    stream<Stream::render>("GR", "Render_Console",
                           "shows progress on the console (the default), and also writes it to a "
                           "file if one is named; -GR: not on the console"),
    stream_file<Stream::render>("Render_File", "file for progress, besides the console; off: none"),
    stream<Stream::statistics>("GS", "Statistic_Console",
                               "shows the summary on the console (the default), and also writes it "
                               "to a file if one is named; -GS: not on the console"),
    stream_file<Stream::statistics>("Statistic_File",
                                    "file for the summary, besides the console; off: none"),
    stream<Stream::warning>("GW", "Warning_Console",
                            "shows warnings on the console (the default), and also writes them to "
                            "a file if one is named; -GW: not on the console"),
    stream_file<Stream::warning>("Warning_File",
                                 "file for warnings, besides the console; off: none"),
    option(none, "", "", "warn", value, "names", store::warn,
           "selects warnings by name, separated by commas: `no-division-by-zero` switches one off, "
           "`none` and `all` switch all of them, `error` turns warnings into errors; see WARNINGS"),
    option(none, "WL", "Warning_Level", "", value, "n", store::warning_level,
           "warning level; 0: no warnings, above 0: all warnings"),
    option(none, "", "", "diagnostics", value, "form",
           one_of<&Options::diagnostics_as_json>(diagnostic_forms),
           "format of messages; json: one object per line and message, and nothing else on the "
           "error stream"),
    option(none, "", "", "progress", value, "form", one_of<&Options::progress>(progress_forms),
           "format of the progress; for programs: json on the error stream, alf (RenderMan's "
           "queues) or openjd (Open Job Description) on standard output, povray (POV-Ray's lines) "
           "on the error stream"),
    that(Touches::writes,
         option(none, "", "", "stats", value, "file", kept<&Options::stats_file>(Type::text),
                "writes statistics of the run as JSON; - writes to standard output; each frame of "
                "an animation has its own numbered file")),

    begin(OptionGroup::commands),
    that(Touches::permits, option(none, "", "", "allow-commands", nothing, "",
                                  kept<&Options::commands, &CommandSettings::allowed>(Type::toggle),
                                  "allows shell commands such as Pre_Scene_Command, which are "
                                  "otherwise skipped; INI files that may come with a scene cannot "
                                  "set --allow-commands, --allow-read or --allow-write")),
    command<Moment::pre_scene>("shell command to run before all else"),
    command_return<Moment::pre_scene>("Pre_Scene_Return"),
    command<Moment::pre_frame>("shell command to run before each picture"),
    command_return<Moment::pre_frame>("Pre_Frame_Return"),
    command<Moment::post_frame>("shell command to run after each picture"),
    command_return<Moment::post_frame>("Post_Frame_Return"),
    command<Moment::post_scene>("shell command to run after all else"),
    command_return<Moment::post_scene>("Post_Scene_Return"),
    command<Moment::user_abort>("shell command to run after a signal has stopped the program"),
    command<Moment::fatal_error>("shell command to run after an error"),

});

constexpr bool is_beginning(const OptionRow& row) {
    return row.letters.empty() && row.keyword.empty() && row.word.empty();
}

/// The rows with their groups, and behind them those that are not offered.
constexpr auto rows = [] {
    constexpr auto beginnings = std::ranges::count_if(listed, is_beginning);
    constexpr std::size_t offered = listed.size() - static_cast<std::size_t>(beginnings);
    std::array<OptionRow, offered + povray_options::rows.size()> all{};
    OptionGroup group{};
    std::size_t count = 0;
    for (const OptionRow& row : listed) {
        if (is_beginning(row)) {
            group = row.group;
            continue;
        }
        all[count] = row;
        all[count++].group = group;
    }
    for (const OptionRow& row : povray_options::rows) {
        all[count] = row;
        all[count++].group = OptionGroup::povray;
    }
    return all;
}();

}  // namespace

std::span<const OptionRow> option_table() { return rows; }

const OptionRow* find_option(std::string_view long_name) {
    for (const OptionRow& row : rows)
        if (candelabra::long_name(row) == long_name) return &row;
    return nullptr;
}

}  // namespace candelabra
