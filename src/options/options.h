// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a value. POV-Ray's switches and keywords and the program's own long options
// are parsed with one table (options/option_table.h). Parsing continues after errors.
#pragma once

#include "interpret/evaluator.h"
#include "interpret/limits.h"
#include "interpret/value.h"
#include "meter/goal.h"
#include "options/animation.h"
#include "options/command_settings.h"
#include "options/picture_layers.h"
#include "options/progress_style.h"
#include "options/shard.h"
#include "options/stream_settings.h"
#include "picture/write.h"
#include "scene/settings.h"
#include "text/diagnostic.h"
#include "text/loader.h"
#include "vocabulary/manual.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace candelabra {

enum class Task {
    render,
    check,
    check_syntax,
    dump_tokens,
    dump_tree,
    dump_scene,
    dump_world,
    dump_index,
    help,
    version,
    describe,
    completion,
    export_mesh,
    measure,
    balance,
    pick
};

/// A name that is declared for the scene, and its value.
using DeclaredValue = std::variant<double, std::string, Numbers>;
using Declaration = std::pair<std::string, DeclaredValue>;

struct OptionRow;

/// An option that was given, as a line of an INI file.
struct GivenOption {
    const OptionRow* row = nullptr;  ///< null: a bare name of a scene
    std::string line;
};

struct Options {
    Task task = Task::render;
    std::optional<std::string> scene;  ///< "-": standard input
    bool strange_names = false;  ///< an INI file that is not the user's own names output files
    std::string output;          ///< as given: a file, a folder, "-" or empty
    bool to_file = true;
    std::string page;  ///< that is made of the picture, beside it; empty: none
    std::optional<PictureType> type;
    std::optional<int> bits;
    bool compressed = false;
    std::vector<std::string> libraries;  ///< searched before the standard library
    std::vector<std::string> library_paths;
    std::vector<std::string> readable;  ///< folders below which the scene may also read
    std::vector<std::string> writable;  ///< folders below which it may also write
    std::optional<bool> sandbox;        ///< unset: where the system has one
    Limits limits;
    std::optional<std::uint64_t> memory_bytes;  ///< of the whole run; unset: the default
    unsigned at_once = 1;                       ///< scenes that may be in progress at the same time
    bool prepared_ahead = false;                ///< prepares a frame while another is rendered
    std::vector<Declaration> declares;
    AnimationSettings animation;
    RunFacts facts;                       ///< other facts for the scene; the size is that of render
    std::pair<int, int> picked;           ///< of --pick: column and row, from 0
    std::string mesh_file;                ///< of --export-mesh
    std::string mesh_object;              ///< the declared object to export; empty: the whole scene
    /// Of --measure: what the meters say; of --light-balance: where light ends.
    std::string readings_file;
    /// The results are for the program that calls the run: layers need no file, and readings are
    /// JSON. No option sets it.
    bool for_caller = false;
    MeterGoal meter_goal;                 ///< how good that has to be
    std::string kept_lights;              ///< receives the light of each lamp; empty: none
    std::optional<std::uint64_t> kept_lights_bytes;  ///< most; unset: by the picture's size
    std::string movie;                    ///< made from the frames; empty: none
    std::string sheet;                    ///< as given, such as 4x3 Seed=1..12; empty: none
    double frame_rate = 25;               ///< of the movie, in frames per second
    std::optional<std::string> ini_file;  ///< receives all options
    std::vector<GivenOption> given;       ///< all options as given, in order
    RenderSettings render;
    bool verbose = true;
    StreamSettings streams;    ///< destinations of the output by kind
    CommandSettings commands;  ///< of the shell, run before and after pictures
    bool diagnostics_as_json = false;
    std::string stats_file;
    bool light_report = false;
    std::vector<PictureLayer> layers;  ///< beside the colours, in an OpenEXR file
    bool denoise = false;              ///< also makes a denoised picture
    bool draft = false;                ///< the picture itself is denoised, and has its own name
    bool alpha = false;                ///< adds the opacity of pixels
    bool grey = false;                 ///< one channel instead of three
    double file_gamma = -1;            ///< of pictures with integer values; below 0: sRGB
    std::string depfile;               ///< rule for make; empty: none
    ProgressShare share;               ///< of the run's work on all pictures
    std::string progress = "auto";     ///< or plain, json, alf, openjd, povray, none
    std::optional<int> preview_port;   ///< nothing: no preview
    std::string preview_host;          ///< address on which it listens; empty: this machine's own
    bool go_on = false;                ///< continues from the state of an earlier run
    bool keep_state = false;           ///< even if the picture is finished
    bool leaves_state = true;          ///< if the picture is not finished
    double checkpoint_interval = 60;   ///< seconds between two states; 0: only on signals
    std::optional<double> time;        ///< seconds after which the picture is ended as it is
    std::string shard;                 ///< as given; empty: the whole
    std::optional<ShardBy> shard_by;   ///< nothing: frames of an animation, samples of a picture
    /// Part of the picture, as POV-Ray counts; see options/region.h.
    std::optional<double> start_row, end_row, start_column, end_column;
    std::string topic;                   ///< of --help or --describe, or a shell
    ManualForm form = ManualForm::text;  ///< of --describe
};

/// Whether progress and statistics, the output other than diagnostics, go to the error stream.
inline bool talks(const Options& options) {
    return options.verbose && !options.diagnostics_as_json;
}

/// Parses the program's arguments, without its name. All errors are in the diagnostics. `read`
/// reads the INI files that they name. `settings`: the INI file of the user or of all users, read
/// first, with any extension; empty: none. `usual`: what holds where neither says otherwise.
Options read_options(std::span<const std::string_view> arguments, Diagnostics&, const Reader& = {},
                     const std::string& settings = {}, Options usual = {});

/// Whether the task makes a table of light, and no picture.
inline bool measures_light(const Options& options) {
    return options.task == Task::measure || options.task == Task::balance;
}

}  // namespace candelabra
