// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/solve_command.h"

#include "app/sandbox.h"
#include "options/memory_limit.h"
#include "options/options.h"
#include "tasks/scene_run.h"
#include "tasks/solve_powers.h"
#include "text/decimal.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>
#include <memory>
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
    SolveReader(std::span<const std::string_view> arguments, Diagnostics& diagnostics)
        : arguments_(arguments), diagnostics_(diagnostics) {}

    SolveWords read(const std::string& settings) {
        std::vector<std::string_view> others;
        for (; at_ < arguments_.size(); ++at_)
            if (!take(arguments_[at_])) others.push_back(arguments_[at_]);
        made_.options = read_options(others, diagnostics_, disk_reader(), settings);
        if (!diagnostics_.failed()) check();
        made_.options.task = Task::measure;
        made_.options.readings_file = output_;
        return std::move(made_);
    }

private:
    /// Takes an option of solve. Returns false for others.
    bool take(std::string_view argument) {
        const std::size_t equals = argument.find('=');
        const std::string_view name = argument.substr(0, equals);
        const auto value = [&] {
            if (equals != argument.npos) return std::string(argument.substr(equals + 1));
            if (at_ + 1 < arguments_.size()) return std::string(arguments_[++at_]);
            fail(message("`", name, "` needs a value"), "");
            return std::string();
        };
        if (argument.starts_with("+O"))
            output_ = argument.substr(2);
        else if (name == "-o" || name == "--output")
            output_ = value();
        else if (name == "--on")
            name_meter(value());
        else if (name == "--lux" || name == "--mean-lux")
            add_demand(name, value(), name == "--mean-lux");
        else if (name == "--lamps")
            made_.solve.lamps.push_back(value());
        else if (argument == "--together")
            made_.solve.together = true;
        else if (name == "--max-power")
            read_most(value());
        else
            return false;
        return true;
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

    std::span<const std::string_view> arguments_;
    Diagnostics& diagnostics_;
    SolveWords made_;
    std::size_t at_ = 0;
    std::string output_;
    std::optional<std::string> meter_;  ///< of --on
    bool bounded_ = false;              ///< whether something is asked of the last one
};

}  // namespace

int run_solve(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    SolveWords words = SolveReader(arguments, diagnostics).read(console.settings);
    Options& options = words.options;
    if (!options.memory_bytes) options.memory_bytes = usual_memory_limit();
    options.libraries.insert(options.libraries.end(), console.first_libraries.begin(),
                             console.first_libraries.end());
    options.commands = {};
    const bool ready =
        !diagnostics.failed() &&
        confined(options, sandbox_rules(options, console.library), console, diagnostics);
    if (!ready) {
        say_errors(console, options, diagnostics);
        return exit_status::usage;
    }
    Console own = console;
    own.made_files = std::make_shared<MadeFiles>(*options.scene);
    return run_over_scene(options, own, diagnostics,
                          [&](SceneSteps& steps) { return solve_powers(steps, words.solve); });
}

}  // namespace candelabra
