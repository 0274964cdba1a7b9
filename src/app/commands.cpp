// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/animation_run.h"
#include "app/develop_command.h"
#include "app/fmt.h"
#include "app/frame_commands.h"
#include "app/help.h"
#include "app/light_command.h"
#include "app/lsp.h"
#include "app/merge.h"
#include "app/new_scene.h"
#include "app/povray_command.h"
#include "app/preview.h"
#include "app/relight_command.h"
#include "app/share_command.h"
#include "app/sheet_run.h"
#include "app/shell_commands.h"
#include "app/solve_command.h"
#include "app/surroundings.h"
#include "options/completion.h"
#include "options/memory_limit.h"
#include "options/option_help.h"
#include "options/option_store.h"
#include "output/measurement.h"
#include "output/mesh_export.h"
#include "production/version.h"
#include "tasks/measuring.h"
#include "tasks/scene_run.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <unistd.h>

namespace candelabra {

namespace {

std::string explanation(const Options& options, const std::string& library,
                        Diagnostics& diagnostics) {
    if (options.task == Task::version) return message(program_name(), "\n");
    if (options.task == Task::completion) return completion(options.topic).value_or("");
    if (options.task == Task::help) return help_text(options.topic, library, diagnostics);
    return description(options.topic, options.form, library, diagnostics);
}

int run_task(const Options& options, const std::optional<Animation>& animation,
             const std::optional<Sheet>& sheet, const Console& console, Diagnostics& diagnostics) {
    if (options.preview_port) return run_preview(options, animation, console, diagnostics);
    const auto work = [&]() -> Outcome {
        if (sheet) return {run_sheet(options, *sheet, console, diagnostics)};
        if (animation) return {run_animation(options, *animation, console, diagnostics)};
        return with_frame_commands(options,
                                   [&] { return run_scene(options, console, diagnostics); });
    };
    return with_commands(options.commands, Moment::pre_scene, Moment::post_scene,
                         command_facts(options), work)
        .status;
}

/// A subcommand of the program, given as the first argument.
struct Command {
    std::string_view name;
    int (*run)(std::span<const std::string_view> arguments, const Console&);
    std::string_view help;
};

/// Runs `describe --json library` as `--describe json library`.
int describe(std::span<const std::string_view> arguments, const Console& console) {
    std::vector<std::string_view> words = {"--describe"};
    for (std::string_view word : arguments) {
        if (word.starts_with("--")) word.remove_prefix(2);
        words.push_back(word);
    }
    return run(words, console);
}

/// Limits the memory of a command as that of a run.
void bound_memory() {
    if (const auto memory = usual_memory_limit()) limit_memory(*memory);
}

constexpr auto commands = std::to_array<Command>({
    {"new", new_scene,
     "usage: candelabra new [--template name] scene.pov\n"
     "Writes a scene to begin with. Templates: studio (the usual one), room, street, flake, "
     "leds.\n"},
    {"merge", merge,
     "usage: candelabra merge [+Ofile] [+Fx] [--partial | --status] state.state.exr ...\n"
     "Joins the states that shards of a picture have left; see candelabra-merge(1).\n"},
    {"develop", run_develop,
     "usage: candelabra develop [-o file] [+Fx] [--layer name] [--exposure stops] ... "
     "picture.exr ...\n"
     "Makes pictures that people look at of the light in OpenEXR files; candelabra-develop(1) "
     "says more.\n"},
    {"relight",
     [](std::span<const std::string_view> arguments, const Console& console) {
         bound_memory();
         return run_relight(arguments, console);
     },
     "usage: candelabra relight [-o file] [--set lamp=value] [--csv frames.csv] [--movie film.mp4] "
     "...\n       file.lights\n"
     "Makes pictures of a scene under other powers and colours of its lamps, without rendering;\n"
     "candelabra-relight(1) says more.\n"},
    {"solve", run_solve,
     "usage: candelabra solve scene.pov --on meter --lux 20..50 [--lamps name] [--max-power 2]\n"
     "       ... -o powers.inc\n"
     "Finds the least powers of lamps with which meters of a scene read what they are to;\n"
     "candelabra-solve(1) says more.\n"},
    {"share", run_share,
     "usage: candelabra share [-o page.html] [option ...] "
     "scene.pov|picture.exr|scene.lights\n"
     "Makes a page to share: a picture whose lamps can be dimmed and coloured in any browser, or "
     "that\nplays a show. Options are those of a picture; see section PAGES TO SHARE of "
     "candelabra(1).\n"},
    {"light",
     [](std::span<const std::string_view> arguments, const Console& console) {
         bound_memory();
         return run_light(arguments, console);
     },
     "usage: candelabra light [--json] [--set n] [-o diagram.svg] file.ies|file.ldt ...\n"
     "Describes the photometry of a luminaire: flux, maximum, efficacy, symmetry, opening, what "
     "was\nrepaired in the file, and its polar diagram.\n"},
    {"povray",
     run_povray,
     "usage: candelabra-povray [option ...] [file.ini] [scene.pov]\n"
     "Renders a scene as POV-Ray's program does with the same options, for programs that call "
     "povray;\ncandelabra-povray(1) says more.\n"},
    {"fmt",
     [](std::span<const std::string_view> arguments, const Console& console) {
         bound_memory();
         return fmt(arguments, console);
     },
     "usage: candelabra fmt [--check] [file ...]\n"
     "Lays scenes out; without files, standard input to standard output. --check only names the\n"
     "files that it would change; see candelabra-fmt(1).\n"},
    {"describe", describe,
     "usage: candelabra describe [--json | --roff] [part]\n"
     "Lists what the language, the options and the library have, for programs as JSON. The parts:\n"
     "items, functions, glossary, examples, library, macros, options, compatibility, missing,\n"
     "words and warnings; without one, all of it as JSON, or the items as text.\n"},
    {"lsp",
     [](std::span<const std::string_view>, const Console& console) {
         // Each scene has a smaller limit of its own (editor/checking.h).
         bound_memory();
         return run_lsp(STDIN_FILENO, console);
     },
     "usage: candelabra lsp\n"
     "Answers an editor's questions by the Language Server Protocol, on standard input and\n"
     "output; see candelabra-lsp(1).\n"},
});

const Command* command_of(std::span<const std::string_view> arguments) {
    if (arguments.empty()) return nullptr;
    const auto found = std::ranges::find(commands, arguments[0], &Command::name);
    return found == commands.end() ? nullptr : &*found;
}

}  // namespace

int run(std::span<const std::string_view> arguments, const Console& console) {
    if (const Command* command = command_of(arguments)) {
        const auto others = arguments.subspan(1);
        if (std::ranges::find(others, "--help") == others.end())
            return command->run(others, console);
        console.out(command->help);
        return exit_status::done;
    }
    Diagnostics diagnostics;
    Options options = read_options(arguments, diagnostics, disk_reader(), console.settings);
    return run_with(std::move(options), console, std::move(diagnostics));
}

int run_with(Options options, const Console& console, Diagnostics diagnostics) {
    const auto end_with_errors = [&](int status) {
        say_errors(console, options, diagnostics);
        return status;
    };
    const std::optional<Animation> animation = plan(options.animation, diagnostics);
    if (!options.movie.empty() && !animation)
        diagnostics.add(error(Fault::option, {}, "a film needs the frames of an animation")
                            .with_help("+KFF240"));
    if (options.task == Task::export_mesh && !mesh_format(options.mesh_file))
        diagnostics.add(error(Fault::option, {},
                              message("a mesh is written as PLY or OBJ, which `",
                                      printable(options.mesh_file), "` is not by its ending"))
                            .with_help("--export-mesh mesh.ply, or mesh.obj"));
    if (measures_light(options)) check_measuring(options, diagnostics);
    if (options.task != Task::measure && options.kept_lights.empty() && is_given(options, "until"))
        diagnostics.add(warning(Fault::no_effect, {},
                                "--until is the error at which --measure ends, and nothing is "
                                "measured at meters")
                            .with_help("--measure light.csv"));
    const std::optional<Sheet> sheet = plan_sheet(options, diagnostics);
    if (!options.preview_host.empty() && !options.preview_port)
        diagnostics.add(error(Fault::option, {}, "--preview-host is the address of a preview")
                            .with_help("--preview 8000 --preview-host 0.0.0.0"));
    if (diagnostics.failed()) return end_with_errors(exit_status::usage);
    if (options.task == Task::help || options.task == Task::version ||
        options.task == Task::describe || options.task == Task::completion) {
        console.out(explanation(options, console.library, diagnostics));
        return diagnostics.failed() ? end_with_errors(exit_status::usage) : exit_status::done;
    }
    if (!options.scene) {
        console.err(short_usage());
        return exit_status::usage;
    }
    return run_with_surroundings(std::move(options), console, diagnostics,
                                 [&](const Options& settled, const Console& sorted) {
                                     return run_task(settled, animation, sheet, sorted,
                                                     diagnostics);
                                 });
}

}  // namespace candelabra
