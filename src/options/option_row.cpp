// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_row.h"

#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

constexpr auto groups = std::to_array<OptionGroupInfo>({
    {OptionGroup::picture, "picture", "size, format and part of the picture"},
    {OptionGroup::quality, "quality", "samples, noise, time and threads"},
    {OptionGroup::light, "light", "light sampler, integrator, luminaires"},
    {OptionGroup::film, "film", "exposure and other steps from light to display"},
    {OptionGroup::scene, "scene", "names, clock, included files and version of the language"},
    {OptionGroup::animation, "animation", "frames, their clocks, and a film of them"},
    {OptionGroup::states, "states", "pauses, continued pictures, and pictures by several machines"},
    {OptionGroup::files, "files", "permissions of scenes, INI files, dependencies"},
    {OptionGroup::limits, "limits", "bounds for scenes that take too much"},
    {OptionGroup::tasks, "tasks", "checks, dumps, meshes, preview and help, instead of a picture"},
    {OptionGroup::console, "console", "messages, warnings, progress and statistics"},
    {OptionGroup::commands, "commands", "shell commands around pictures"},
    {OptionGroup::povray, "compatibility", "POV-Ray's options that have no effect here"},
});

}  // namespace

std::span<const OptionGroupInfo> option_groups() { return groups; }

std::string long_name(const OptionRow& row) {
    if (!row.word.empty()) return std::string(row.word);
    std::string name = lower_case(row.keyword);
    std::ranges::replace(name, '_', '-');
    return name;
}

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
    else if (row.own)
        store_field(row.own, options, given, diagnostics);
    else
        store::field(row.field, options, given, diagnostics);
}

}  // namespace candelabra
