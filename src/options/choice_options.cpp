// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/choice_options.h"

#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <cmath>

namespace candelabra {

namespace {

/// Selects the alternative with this keyword, with its default values.
template <class Variant>
void choose(std::optional<Variant>& chosen, std::string_view noun, const Given& given,
            Diagnostics& diagnostics) {
    using All = Kinds<Variant>;
    std::vector<std::string_view> names;
    for (const ItemInfo* info : All::infos) names.push_back(info->name);
    const std::size_t found = All::find(*given.value);
    if (found < All::count) {
        chosen = All::make(found);
        return;
    }
    std::string help = "there are";
    for (const std::string_view name : names)
        help += message(name == names.front() ? " " : ", ", name);
    const std::string meant = nearest(*given.value, names);
    refuse(given, diagnostics, message("there is no ", noun, " `", printable(*given.value), "`"),
           meant.empty() ? help : message("did you mean `", meant, "`? ", help));
}

}  // namespace

void store::sampler(Options& options, const Given& given, Diagnostics& diagnostics) {
    choose(options.render.light_sampler, "light sampler", given, diagnostics);
}

void store::luminaires(Options& options, const Given& given, Diagnostics& diagnostics) {
    const auto above = number(*given.value);
    if (*given.value == "none")
        options.render.luminaires_above = INFINITY;
    else if (above && *above >= 0)
        options.render.luminaires_above = *above;
    else
        refuse(given, diagnostics, "must be none, or a radiance that is not negative",
               "--luminaires 0.5 leaves those that are dimmer out");
}

void store::integrator(Options& options, const Given& given, Diagnostics& diagnostics) {
    choose(options.render.integrator, "integrator", given, diagnostics);
}

void store::index(Options& options, const Given& given, Diagnostics& diagnostics) {
    choose(options.render.index, "index", given, diagnostics);
}

}  // namespace candelabra
