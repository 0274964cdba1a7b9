// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shell_commands.h"

#include "app/child.h"
#include "console/console.h"
#include "text/message.h"
#include "text/shell_word.h"

#include <optional>

namespace candelabra {

namespace {

std::string fact(char sign, const CommandFacts& facts) {
    switch (sign) {
        case 'o':
            return shell_word(facts.output);
        case 's':
            return shell_word(facts.scene);
        case 'n':
            return message(facts.frame);
        case 'k':
            return message(facts.clock);
        case 'w':
            return message(facts.width);
        case 'h':
            return message(facts.height);
        case '%':
            return "%";
        default:
            return message('%', sign);
    }
}

/// Returns the outcome that ends the work, or nothing if the run continues.
std::optional<Outcome> consequence(const CommandSettings& settings, After after,
                                   const CommandFacts& facts) {
    switch (after) {
        case After::ignore:
            return std::nullopt;
        case After::skip:
            return Outcome{exit_status::done, false};
        case After::all:
        case After::quit:
            return Outcome{exit_status::done, true};
        case After::abort:
            run_command(settings, Moment::user_abort, facts);
            return Outcome{exit_status::stopped, true};
        case After::fatal:
            break;
    }
    run_command(settings, Moment::fatal_error, facts);
    return Outcome{exit_status::scene, true};
}

}  // namespace

std::string filled_in(std::string_view command, const CommandFacts& facts) {
    std::string text;
    for (std::size_t i = 0; i < command.size(); ++i) {
        const bool sign = command[i] == '%' && i + 1 < command.size();
        text += sign ? fact(command[++i], facts) : std::string(1, command[i]);
    }
    return text;
}

After run_command(const CommandSettings& settings, Moment moment, const CommandFacts& facts) {
    const CommandSettings::One& one = settings[moment];
    if (one.command.empty() || !settings.allowed) return After::ignore;
    const bool succeeded = run_program({"/bin/sh", "-c", filled_in(one.command, facts)}) == 0;
    return succeeded == one.inverted ? one.after : After::ignore;
}

Outcome with_commands(const CommandSettings& settings, Moment before, Moment after,
                      const CommandFacts& facts, const std::function<Outcome()>& work) {
    if (const auto ends = consequence(settings, run_command(settings, before, facts), facts))
        return *ends;
    const Outcome outcome = work();
    const bool inner = before == Moment::pre_frame;
    if (outcome.status == exit_status::stopped && inner)
        run_command(settings, Moment::user_abort, facts);
    else if (outcome.status != exit_status::done && inner)
        run_command(settings, Moment::fatal_error, facts);
    if (outcome.status != exit_status::done) return {outcome.status, true};
    const auto ends = consequence(settings, run_command(settings, after, facts), facts);
    return ends ? Outcome{ends->status, ends->ends || outcome.ends} : outcome;
}

}  // namespace candelabra
