// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a value. POV-Ray's switches and keywords and our own long options are read
// from one table (app/option_table.h); what is wrong is reported, and reading goes on.
#pragma once

#include "app/animation.h"
#include "app/layers.h"
#include "app/progress.h"
#include "app/shard.h"
#include "app/shell_commands.h"
#include "app/streams.h"
#include "interpret/evaluator.h"
#include "interpret/limits.h"
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
    export_mesh
};

/// A name that the scene finds declared, and its value.
using Declaration = std::pair<std::string, std::variant<double, std::string>>;

struct Options {
    Task task = Task::render;
    std::optional<std::string> scene;  ///< "-": standard input
    bool strange_names = false;  ///< an INI file that is not the user's own names files to write
    std::string output;          ///< as given: a file, a folder, "-" or nothing
    bool to_file = true;
    std::optional<PictureType> type;
    std::optional<int> bits;
    bool compressed = false;
    std::vector<std::string> library_paths;
    std::vector<std::string> readable;  ///< folders that the scene may read below, too
    std::vector<std::string> writable;  ///< folders that it may write below, too
    std::optional<bool> sandbox;        ///< nothing: where the system has one
    Limits limits;
    std::optional<std::uint64_t> memory_bytes;  ///< of the whole run; nothing: the usual
    unsigned at_once = 1;                       ///< scenes that may be at work at the same time
    bool prepared_ahead = false;                ///< a frame, while another one is rendered
    std::vector<Declaration> declares;
    AnimationSettings animation;
    RunFacts facts;           ///< what else the scene is told; the size is that of render
    std::string mesh_file;    ///< of --export-mesh
    std::string mesh_object;  ///< the declared object that it shows; empty: the whole scene
    std::string movie;        ///< what the frames become; empty: nothing more
    double frame_rate = 25;   ///< of the movie, frames a second
    std::optional<std::string> ini_file;  ///< where all options go
    std::vector<std::string> given;       ///< all options as lines of an INI file
    RenderSettings render = [] {
        RenderSettings unsaid;
        unsaid.shadow_rays = 0;
        return unsaid;
    }();
    bool verbose = true;
    StreamSettings streams;    ///< where what is said goes
    CommandSettings commands;  ///< of the shell, around pictures
    bool diagnostics_as_json = false;
    std::string stats_file;
    bool light_report = false;
    std::vector<PictureLayer> layers;  ///< beside the colours, in an OpenEXR file
    bool denoise = false;              ///< a picture with less noise is made beside the exact one
    bool alpha = false;                ///< how opaque a pixel is
    bool grey = false;                 ///< one channel instead of three
    double file_gamma = -1;            ///< of pictures of whole numbers; below 0: sRGB
    std::string depfile;               ///< rule for make; empty: none
    Progress::Share share;             ///< of all pictures that the run makes
    std::string progress = "auto";     ///< or plain, json, alf, openjd, none
    std::optional<int> preview_port;   ///< nothing: no preview
    bool go_on = false;                ///< from the state that an earlier run has left
    bool keep_state = false;           ///< also of a finished picture
    double checkpoint_interval = 60;  ///< seconds between two states; 0: only when asked by signals
    std::optional<double> time;       ///< seconds after which a picture is finished as it is
    std::string shard;                ///< as given; empty: the whole
    std::optional<ShardBy> shard_by;  ///< nothing: frames of an animation, samples of a picture
    /// Part of the picture, as POV-Ray counts; see app/region.h.
    std::optional<double> start_row, end_row, start_column, end_column;
    std::string topic;                   ///< of --help, what --describe describes, or a shell
    ManualForm form = ManualForm::text;  ///< of --describe
};

/// Whether there is progress, and figures, on the error stream: everything that is no diagnostic.
inline bool talks(const Options& options) {
    return options.verbose && !options.diagnostics_as_json;
}

/// The program's arguments, without its name. Everything wrong with them is in the diagnostics. INI
/// files that they name are read with the reader; before them the file with everybody's settings,
/// whatever its ending. Empty: there is none.
Options read_options(std::span<const std::string_view> arguments, Diagnostics&, const Reader& = {},
                     const std::string& settings = {});

}  // namespace candelabra
