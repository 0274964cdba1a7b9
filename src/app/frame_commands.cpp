// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame_commands.h"

#include "options/output.h"

#include <filesystem>

namespace candelabra {

CommandFacts command_facts(const Options& options) {
    Diagnostics said_elsewhere;
    return {output_of(options, said_elsewhere).path,
            std::filesystem::path(*options.scene).replace_extension().string(),
            options.facts.frame_number,
            options.facts.clock,
            options.render.width,
            options.render.height};
}

Outcome with_frame_commands(const Options& options, const std::function<int()>& work) {
    return with_commands(options.commands, Moment::pre_frame, Moment::post_frame,
                         command_facts(options), [&]() -> Outcome { return {work()}; });
}

}  // namespace candelabra
