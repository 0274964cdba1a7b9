// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/solve_command.h"

#include "app/frame_commands.h"
#include "app/surroundings.h"
#include "options/options.h"
#include "options/subcommands.h"
#include "tasks/scene_run.h"
#include "tasks/solve_powers.h"
#include "text/decimal.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

struct SolveWords {
    Options options;
    SolveRequest solve;
};

class SolveReader {
public:
    explicit SolveReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    SolveWords read(std::span<const std::string_view> arguments, const std::string& settings) {
        const std::vector<std::string> others = take_options(
            "solve", arguments,
            [&](std::string_view name, std::string value) { take(name, std::move(value)); },
            diagnostics_);
        made_.options = read_options(std::vector<std::string_view>(others.begin(), others.end()),
                                     diagnostics_, disk_reader(), settings);
        if (!diagnostics_.failed()) check();
        made_.options.task = Task::measure;
        made_.options.readings_file = output_;
        return std::move(made_);
    }

private:
    void take(std::string_view name, std::string value) {
        if (name == "--output")
            output_ = std::move(value);
        else if (name == "--on")
            name_meter(std::move(value));
        else if (name == "--lux" || name == "--mean-lux")
            add_demand(name, value, name == "--mean-lux");
        else if (name == "--lamps")
            made_.solve.lamps.push_back(std::move(value));
        else if (name == "--together")
            made_.solve.together = true;
        else
            read_most(value);
    }

    void name_meter(std::string name) {
        check_bounded();
        meter_ = std::move(name);
        bounded_ = false;
    }

    void check_bounded() {
        if (meter_ && !bounded_)
            fail(message("`--on ", printable(*meter_), "` says where, and nothing says how much"),
                 "--lux 20..50 behind it");
    }

    void add_demand(std::string_view name, const std::string& range, bool of_mean) {
        if (!meter_)
            return fail(message("`", name, "` stands before any --on, which says where"),
                        message("--on Street ", name, " 20..50"));
        bounded_ = true;
        MeterDemand demand{*meter_};
        demand.of_mean = of_mean;
        const std::size_t dots = range.find("..");
        const std::string low = range.substr(0, dots);
        const std::string high = dots == range.npos ? "" : range.substr(dots + 2);
        const auto from = low.empty() ? std::optional(0.0) : finite_number(low);
        const auto to = high.empty() ? std::optional(demand.high) : finite_number(high);
        const bool good = dots != range.npos && range.size() > 2 && from && to && *from >= 0 &&
                          *to > 0 && *from <= *to;
        if (!good)
            return fail(message("`", name, " ", printable(range), "` is no range of lux from 0 on"),
                        message(name, " 20..50, ", name, " 20.. or ", name, " ..50"));
        demand.low = *from;
        demand.high = *to;
        made_.solve.demands.push_back(std::move(demand));
    }

    void read_most(const std::string& text) {
        const auto most = finite_number(text);
        if (!most || !(*most > 0))
            return fail(message("`--max-power ", printable(text), "` is no number above 0"),
                        "--max-power 2 permits twice the power that the scene gives a lamp");
        made_.solve.most = *most;
    }

    void check() {
        check_bounded();
        const Options& options = made_.options;
        constexpr auto example =
            "candelabra solve scene.pov --on Street --lux 20..50 -o powers.inc";
        if (!options.scene)
            fail("solve needs a scene", example);
        else if (options.task != Task::render || options.preview_port || !options.movie.empty())
            fail("solve finds powers and does nothing else", example);
        else if (options.animation.final_frame || options.animation.initial_frame ||
                 !options.sheet.empty() || !options.shard.empty())
            fail("solve works on a single scene, and not on frames or parts", example);
        else if (options.denoise || options.draft)
            fail("solve takes light as it is, and --denoise and --draft change pictures", "");
        else if (!meter_)
            fail("solve needs what a meter is to read", example);
        else if (output_.empty())
            fail("solve needs a file for the powers", "-o powers.inc, or -o - to print them");
    }

    void fail(std::string text, std::string help) {
        diagnostics_.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
    }

    Diagnostics& diagnostics_;
    SolveWords made_;
    std::string output_;
    std::optional<std::string> meter_;  ///< of --on
    bool bounded_ = false;              ///< whether something is asked of the last one
};

}  // namespace

int run_solve(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    SolveWords words = SolveReader(diagnostics).read(arguments, console.settings);
    if (diagnostics.failed()) {
        say_errors(console, words.options, diagnostics);
        return exit_status::usage;
    }
    return run_with_surroundings(
        std::move(words.options), console, diagnostics,
        [&](const Options& options, const Console& own) {
            const auto solve = [&] {
                return run_over_scene(options, own, diagnostics, [&](SceneSteps& steps) {
                    return solve_powers(steps, words.solve);
                });
            };
            return with_commands(options.commands, Moment::pre_scene, Moment::post_scene,
                                 command_facts(options),
                                 [&]() -> Outcome { return with_frame_commands(options, solve); })
                .status;
        });
}

}  // namespace candelabra
