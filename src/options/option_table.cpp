// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_table.h"

#include "options/choice_options.h"
#include "options/console_options.h"
#include "options/film_options.h"
#include "options/option_values.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

using enum Takes;
using enum Changes;
using Type = OptionField::Type;

constexpr std::string_view no_radiosity = "radiosity has no cache";
constexpr std::string_view no_preview = "no preview is shown";
constexpr std::string_view order = "tiles are made in their own order, all better and better";
constexpr std::string_view older = "it changes nothing in a picture";
constexpr std::string_view over = "the run has ended then";
constexpr std::string_view index = "objects are always found through an index; see --index";

constexpr double megabyte = 1 << 20, million = 1e6;

// The names of choices stand in the order of their values.
constexpr std::array<std::string_view, 3> parts_of_work = {"samples", "tiles", "frames"};
constexpr std::array<std::string_view, 2> off_or_on = {"off", "on"};
constexpr std::array<std::string_view, 2> diagnostic_forms = {"text", "json"};
constexpr std::array<std::string_view, 6> progress_forms = {"auto", "plain",  "json",
                                                            "alf",  "openjd", "none"};

void room_for_depth(Options& options) { options.limits.make_room(); }

/// The language counts elements in 32 bits.
void countable_elements(Options& options) {
    constexpr std::size_t most = 2'000'000'000;
    options.limits.array_elements = std::min(options.limits.array_elements, most);
}

using Store = void (*)(Options&, const Given&, Diagnostics&);
using Values = std::vector<std::string> (*)(const Options&);
using Term = std::string_view;

/// The rows behind this one belong to the group. It is no option.
constexpr OptionRow begin(OptionGroup group) {
    OptionRow row{};
    row.group = group;
    return row;
}

/// An option that the short help lists.
constexpr OptionRow basic(OptionRow row) {
    row.basic = true;
    return row;
}

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
    return {letters, keyword, word, parameter, takes, help, changes, {}, {}, store, values};
}

/// `values`: what is in force, if that is not simply the value that was given.
constexpr OptionRow option(Changes changes, Term letters, Term keyword, Term word, Takes takes,
                           Term parameter, OptionField own, Term help, Values values = nullptr) {
    return {letters, keyword, word, parameter, takes, help, changes, {}, own, nullptr, values};
}

/// A limit of the scene or the run. `then` adapts what depends on it.
constexpr OptionRow limit(Term word, Term parameter, OptionField own, Term help,
                          void (*then)(Options&) = nullptr) {
    own.then = then;
    return option(none, "", "", word, value, parameter, own, help);
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
constexpr OptionRow stream_file(Term keyword, Term help) {
    return that(Touches::writes,
                option(none, "", keyword, "", value, "file", store::stream_file<which>, help));
}

template <Moment moment>
constexpr OptionRow command(Term keyword, Term help) {
    return option(none, "", keyword, "", value, "command", store::command<moment>, help);
}

template <Moment moment>
constexpr OptionRow command_return(Term keyword) {
    return option(
        none, "", keyword, "", value, "action", store::command_return<moment>,
        "what follows if this command fails: I nothing, S the picture is skipped, A all are, Q "
        "the run ends, U it is aborted, F it fails; -S and so on: what follows if it succeeds");
}

/// The table with its groups' beginnings. Commands that pictures record have options in this order.
constexpr auto listed = std::to_array<OptionRow>({
    begin(OptionGroup::picture),
    that(
        Touches::reads,
        option(none, "I", "Input_File_Name", "", value, "file", store::scene,
               "scene to read; - for standard input; a bare file name is one without this option")),
    basic(that(Touches::writes,
               option(format, "O", "Output_File_Name", "output", value, "file",
                      kept<&Options::output>(Type::text),
                      "picture to write; a folder keeps the scene's name; - for standard output; "
                      "the ending says the format where +F does not",
                      in_force::unsaid))),
    option(format, "F", "Output_to_File", "", sign_and_value, "x", store::to_file,
           "format: N png (N16: 16 bits a channel), E OpenEXR and H Radiance HDR (linear), P ppm, "
           "T tga, C compressed tga, J jpeg, B bmp, I tiff (I16), W webp; -F writes no file",
           in_force::type),
    option(format, "", "Output_File_Type", "", value, "x", store::type,
           "format of the picture, by the letters of +F"),
    option(format, "", "Bits_Per_Color", "", value, "n", store::bits,
           "bits of each channel of a png or tiff: 8 or 16", in_force::bits),
    option(format, "", "Grayscale_Output", "", sign, "", kept<&Options::grey>(Type::toggle),
           "one channel of grey (png and tiff of 16 bits, ppm), as with +FNg"),
    option(picture, "UA", "Output_Alpha", "", sign, "", kept<&Options::alpha>(Type::toggle),
           "an alpha channel: how opaque a pixel is (png, tga, OpenEXR); clear is what lies behind "
           "everything, unless a background or a sky_sphere that is not transparent is there"),
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
    basic(
        option(samples, "", "", "time", value, "duration",
               kept<&Options::time>(Type::duration, above(0)),
               "finishes the picture as it is after this time (90s, 10m, 2h); the one option that "
               "makes a picture depend on the machine")),
    setting(picture, "", "", "shadow-rays", "shadow_rays"),

    begin(OptionGroup::picture),
    option(picture, "", "", "layers", value, "names", store::layers,
           "layers beside the colours, with commas between: albedo, normal, depth, object, lights "
           "(one for each statement that makes lights), variance, samples, shadow_rays, or all; in "
           "the picture if that is OpenEXR, otherwise in a file .layers.exr beside it; see LAYERS",
           in_force::layers),
    option(picture, "SR", "Start_Row", "", value, "n",
           kept<&Options::start_row>(Type::number, at_least(0)),
           "first row that is rendered, from 1; below 1 a fraction; the picture is black elsewhere",
           in_force::start_row),
    option(picture, "ER", "End_Row", "", value, "n",
           kept<&Options::end_row>(Type::number, at_least(0)),
           "last row that is rendered; up to 1 a fraction", in_force::end_row),
    option(picture, "SC", "Start_Column", "", value, "n",
           kept<&Options::start_column>(Type::number, at_least(0)), "first column that is rendered",
           in_force::start_column),
    option(picture, "EC", "End_Column", "", value, "n",
           kept<&Options::end_column>(Type::number, at_least(0)), "last column that is rendered",
           in_force::end_column),

    begin(OptionGroup::quality),
    basic(setting(none, "WT", "Work_Threads", "threads", "threads")),

    begin(OptionGroup::light),
    basic(option(picture, "", "", "light-sampler", value, "name", store::sampler,
                 "way to choose luminaires, instead of the scene's; see LIGHT SAMPLERS",
                 in_force::sampler)),
    option(picture, "", "", "integrator", value, "name", store::integrator,
           "how light is followed, instead of the scene's: pov_ray or path_traced; see "
           "INTEGRATORS",
           in_force::integrator),

    begin(OptionGroup::quality),
    basic(option(picture, "", "", "denoise", nothing, "", kept<&Options::denoise>(Type::toggle),
                 "makes a picture with less noise beside the exact one, a.denoised.png with a.png, "
                 "or the layer denoised in an OpenEXR file; see NOISE AND TIME")),
    basic(option(picture, "", "", "draft", nothing, "", kept<&Options::draft>(Type::toggle),
                 "a.draft.png instead of a.png: 4 samples for each pixel, or --samples, denoised")),

    begin(OptionGroup::light),
    option(none, "", "", "index", value, "name", store::index,
           "what finds the surfaces that rays meet, instead of the scene's: kd_tree or "
           "bounding_boxes; pictures do not depend on it"),
    option(none, "", "", "light-report", nothing, "", kept<&Options::light_report>(Type::toggle),
           "reports at the end what the lights of each statement gave and what they cost"),

    begin(OptionGroup::film),
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

    begin(OptionGroup::quality),
    setting(picture, "", "", "seed", "seed"),

    begin(OptionGroup::scene),
    basic(that(Touches::reads,
               option(folders, "L", "Library_Path", "", value, "folder",
                      kept<&Options::library_paths>(Type::list),
                      "folder to look for included files in; may be given several times",
                      in_force::library))),
    that(Touches::reads,
         option(folders, "", "", "library", value, "folder", kept<&Options::libraries>(Type::list),
                "folder of include files, such as POV-Ray's, before those of the standard library",
                in_force::first_libraries)),
    option(picture, "", "Declare", "", value, "name=value", store::declare,
           "declares a name for the scene: a number, or a string in quotes", in_force::declares),
    that(Touches::reads,
         option(none, "", "", "preset", value, "file", store::preset,
                "declares the names of a JSON file, such as the preview saves, with their values")),
    option(picture, "K", "Clock", "", value, "n", store::clock, "value of clock in the scene",
           in_force::clock),

    begin(OptionGroup::animation),
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

    begin(OptionGroup::scene),
    that(Touches::searches,
         option(folders, "HI", "Include_Header", "", value, "file", store::header,
                "file that is included before the scene", in_force::header)),
    option(picture, "MV", "Version", "language-version", value, "n",
           kept<&Options::facts, &RunFacts::version>(Type::number, at_least(1)),
           "version of the language until the scene says one"),

    begin(OptionGroup::quality),
    setting(picture, "Q", "Quality", "", "quality"),

    begin(OptionGroup::light),
    option(picture, "", "", "luminaires", value, "n", store::luminaires,
           "which of the things that glow light others, instead of the scene's rule: those with a "
           "radiance above n, or none",
           in_force::luminaires),
    option_field(picture, "", "", "ambient-luminaires", nothing, "ambient_luminaires"),

    begin(OptionGroup::picture),
    option(picture, "", "File_Gamma", "", value, "g", store::gamma,
           "how pictures of whole "
           "numbers are encoded: sRGB (the default), bt709, bt2020, or a power of which this is "
           "the inverse; "
           "OpenEXR and Radiance HDR are linear",
           in_force::gamma),

    begin(OptionGroup::animation),
    option_field(none, "", "", "skip-existing", nothing, "skip_existing"),
    that(Touches::writes,
         option(none, "", "", "movie", value, "file", kept<&Options::movie>(Type::text),
                "makes a film of all frames with ffmpeg, when they are done; the "
                "ending says which kind")),
    option(none, "", "", "frame-rate", value, "n",
           kept<&Options::frame_rate>(Type::number, Range{0, 1000, true}),
           "frames a second in the film of --movie"),

    begin(OptionGroup::states),
    basic(option(
        none, "C", "Continue_Trace", "", sign, "", kept<&Options::go_on>(Type::toggle),
        "goes on from the state that an earlier run has left beside the picture; see STATES")),
    option(none, "", "", "checkpoint", value, "duration",
           kept<&Options::checkpoint_interval>(Type::duration, between(0, 1e9)),
           "time between two states while a picture is made; 0: only on signals"),
    option(none, "", "", "keep-state", nothing, "", kept<&Options::keep_state>(Type::toggle),
           "keeps the state of a finished picture, so that +C can add samples"),
    option(none, "", "", "shard", value, "i/n", kept<&Options::shard>(Type::text),
           "makes one of n parts, for merge; auto: as the job array of Slurm or AWS Batch says, "
           "auto/n with Kubernetes; see FARMS"),
    option(none, "", "", "shard-by", value, "what", one_of<&Options::shard_by>(parts_of_work),
           "what the parts of --shard are; without it frames of an animation, and samples of a "
           "picture"),

    begin(OptionGroup::files),
    that(Touches::permits,
         option(none, "", "", "allow-read", value, "folder", kept<&Options::readable>(Type::list),
                "folder below which the scene may read, too; may be given several times")),
    that(Touches::permits,
         option(none, "", "", "allow-write", value, "folder", kept<&Options::writable>(Type::list),
                "folder below which the scene may write, too; may be given several times")),
    that(Touches::permits,
         option(none, "", "", "sandbox", value, "on|off", one_of<&Options::sandbox>(off_or_on),
                "whether the program confines itself to the files and system calls that the run "
                "needs; on where the system can do that (Linux's Landlock and seccomp), off with "
                "--allow-commands")),
    option(none, "", "Include_Ini", "", value, "file", store::include_ini, "INI file to read, too"),
    that(Touches::writes_ini, option(none, "GI", "", "", sign_and_value, "file", store::create_ini,
                                     "writes all options in force to an INI file")),
    that(Touches::writes_ini, option(none, "", "Create_Ini", "", value, "file", store::create_ini,
                                     "INI file to which all options in force are written; off: "
                                     "none")),
    that(Touches::writes,
         option(none, "", "", "depfile", value, "file", kept<&Options::depfile>(Type::text),
                "writes a rule for make(1) with all files that the picture was made from; of "
                "frames each has its own, with a number")),

    begin(OptionGroup::limits),
    limit("limit-steps", "n", kept<&Options::limits, &Limits::steps>(Type::whole, between(1, 1e12)),
          "most passes of loops and calls of macros in a scene"),
    limit("limit-depth", "n",
          kept<&Options::limits, &Limits::call_depth>(Type::whole, between(1, 1e8)),
          "most calls of macros that are open inside each other", room_for_depth),
    limit("limit-nesting", "n",
          kept<&Options::limits, &Limits::nesting>(Type::whole, between(1, 1e8)),
          "most objects inside each other", room_for_depth),
    limit("limit-objects", "n",
          kept<&Options::limits, &Limits::objects>(Type::whole, between(1, 1e12)),
          "most objects that a scene makes, parts of unions included"),
    limit("limit-includes", "n",
          kept<&Options::limits, &Limits::include_depth>(Type::whole, between(1, 1e12)),
          "most included files that are open inside each other"),
    limit("limit-files", "n", kept<&Options::limits, &Limits::files>(Type::whole, between(1, 1e12)),
          "most files that a scene includes or opens, each time counted"),
    limit("limit-elements", "n",
          kept<&Options::limits, &Limits::array_elements>(Type::whole, between(1, 1e12)),
          "most elements of one array", countable_elements),
    limit("limit-written", "MB",
          kept<&Options::limits, &Limits::written_bytes>(Type::whole, between(1, 1e12), megabyte),
          "most megabytes that the scene writes with #write"),
    limit("limit-said", "MB",
          kept<&Options::limits, &Limits::said_bytes>(Type::whole, between(1, 1e12), megabyte),
          "most megabytes of text from #debug and its relatives"),
    limit("limit-text", "MB",
          kept<&Options::limits, &Limits::text_bytes>(Type::whole, between(1, 1e12), megabyte),
          "most megabytes of one string"),
    limit("limit-function", "n",
          kept<&Options::limits, &Limits::function_steps>(Type::whole, between(1, 1e12)),
          "most steps of one call of a function, its loops run once"),
    limit("limit-work", "n",
          kept<&Options::limits, &Limits::work>(Type::whole, between(1, 1e12), million),
          "most millions of steps of any kind before the scene is rendered"),
    limit("limit-memory", "MB",
          kept<&Options::memory_bytes>(Type::whole, between(1, 1e12), megabyte),
          "most megabytes of memory for the run; half of what is free at the start without it"),
    option(none, "", "", "memory", value, "size",
           kept<&Options::memory_bytes>(Type::size, between(0x1p20, 0x1p60)),
           "most memory for the run, such as 500M or 8G: --limit-memory with a unit"),

    begin(OptionGroup::tasks),
    basic(option(
        none, "", "", "check", maybe_value, "syntax", store::check,
        "evaluates the scene and says what is wrong, without rendering; with --stats it also "
        "builds what rays need; =syntax: reads the scene, but does not evaluate it")),
    option(
        none, "", "", "dump", value, "stage", store::dump,
        "prints what the scene is at a stage: tokens, tree, scene, world, or index (a drawing in "
        "SVG of the cells that a slice cuts)"),
    that(
        Touches::writes,
        option(none, "", "", "export-mesh", value, "file", store::export_mesh,
               "writes the scene's surfaces as triangles to a file, PLY or OBJ by its ending, and "
               "renders nothing; shapes are taken apart, intersections and differences are exact")),
    option(none, "", "", "export-object", value, "name", kept<&Options::mesh_object>(Type::text),
           "what --export-mesh writes: a declared object in the place of the whole scene"),
    basic(that(Touches::permits,
               option(none, "", "", "preview", value, "port", store::preview,
                      "shows the picture at http://localhost:PORT/ while it becomes "
                      "better, and makes it anew "
                      "when the scene changes; 0: any free port"))),
    basic(option(none, "", "", "help", maybe_words, "topic", store::help,
                 "the usual options; all: every option; or an explanation of an option, an item or "
                 "a group of them")),
    option(none, "", "", "version", nothing, "", store::version, "name and version"),
    option(none, "", "", "describe", maybe_words, "form part", store::describe,
           "options and vocabulary as text, roff or json; part: items, functions, glossary, "
           "library, macros, options, compatibility, missing, words, warnings or textmate (a "
           "grammar)"),
    option(none, "", "", "completion", value, "shell", store::completion,
           "prints what completes options in bash, zsh or fish"),

    begin(OptionGroup::console),
    option(none, "V", "Verbose", "", sign, "", kept<&Options::verbose>(Type::toggle),
           "progress and a summary (the default); -V: only warnings, errors and what the scene "
           "says"),
    that(Touches::writes,
         option(none, "GA", "All_Console", "", sign_and_value, "file", store::all_streams,
                "all that is said appears (the default), and goes to a file, too; -GA: nothing "
                "appears")),
    that(Touches::writes, option(none, "", "All_File", "", value, "file", store::all_stream_files,
                                 "file for all that is said, besides the console; off: none")),
    stream<Stream::debug>(
        "GD", "Debug_Console",
        "what the scene says on the console (the default), and in a file; -GD: only there"),
    stream_file<Stream::debug>("Debug_File",
                               "file for what the scene says, besides the console; off: none"),
    stream<Stream::fatal>("GF", "Fatal_Console",
                          "errors on the console (the default), and in a file, too; -GF: not on "
                          "the console"),
    stream_file<Stream::fatal>("Fatal_File", "file for errors, besides the console; off: none"),
    stream<Stream::render>("GR", "Render_Console",
                           "progress on the console (the default), and in a file, too; -GR: not on "
                           "the console"),
    stream_file<Stream::render>("Render_File", "file for progress, besides the console; off: none"),
    stream<Stream::statistics>(
        "GS", "Statistic_Console",
        "the summary on the console (the default), and in a file; -GS: only there"),
    stream_file<Stream::statistics>("Statistic_File",
                                    "file for the summary, besides the console; off: none"),
    stream<Stream::warning>(
        "GW", "Warning_Console",
        "warnings on the console (the default), and in a file; -GW: only there"),
    stream_file<Stream::warning>("Warning_File",
                                 "file for warnings, besides the console; off: none"),
    option(none, "", "", "warn", value, "names", store::warn,
           "warnings by name, with commas between: `no-division-by-zero` switches one off, `none` "
           "and `all` do what they say, `error` makes warnings errors; see WARNINGS"),
    option(none, "WL", "Warning_Level", "", value, "n", store::warning_level,
           "0: no warnings; above: all warnings"),
    option(none, "", "", "diagnostics", value, "form",
           one_of<&Options::diagnostics_as_json>(diagnostic_forms),
           "form of messages; json: an object on a line for each message, and nothing else on the "
           "error stream"),
    option(none, "", "", "progress", value, "form", one_of<&Options::progress>(progress_forms),
           "form of the progress; for programs: json on the error stream, alf (of RenderMan's "
           "queues) or openjd (Open Job Description) on the standard output"),
    that(Touches::writes,
         option(none, "", "", "stats", value, "file", kept<&Options::stats_file>(Type::text),
                "writes what the run cost as JSON; - for standard output; of frames each has its "
                "own, with a number")),

    begin(OptionGroup::commands),
    that(Touches::permits,
         option(none, "", "", "allow-commands", nothing, "",
                kept<&Options::commands, &CommandSettings::allowed>(Type::toggle),
                "runs commands such as that of Pre_Scene_Command, which are left out otherwise; no "
                "INI file that may come with a scene can say this, --allow-read or "
                "--allow-write")),
    command<Moment::pre_scene>("Pre_Scene_Command", "shell command that is run before everything"),
    command_return<Moment::pre_scene>("Pre_Scene_Return"),
    command<Moment::pre_frame>("Pre_Frame_Command",
                               "shell command that is run before each picture"),
    command_return<Moment::pre_frame>("Pre_Frame_Return"),
    command<Moment::post_frame>("Post_Frame_Command",
                                "shell command that is run after each picture"),
    command_return<Moment::post_frame>("Post_Frame_Return"),
    command<Moment::post_scene>("Post_Scene_Command", "shell command that is run after everything"),
    command_return<Moment::post_scene>("Post_Scene_Return"),
    command<Moment::user_abort>("User_Abort_Command",
                                "shell command that is run after a signal has ended the work"),
    command<Moment::fatal_error>("Fatal_Error_Command", "shell command that is run after an error"),

    begin(OptionGroup::povray),
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
    ignored("MI", "Max_Image_Buffer_Memory", value, "n", "pictures are kept in memory: --memory"),
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

constexpr bool is_beginning(const OptionRow& row) {
    return row.letters.empty() && row.keyword.empty() && row.word.empty();
}

constexpr auto rows = [] {
    constexpr auto beginnings = std::ranges::count_if(listed, is_beginning);
    std::array<OptionRow, listed.size() - static_cast<std::size_t>(beginnings)> all{};
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
