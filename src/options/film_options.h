// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of the options that change the camera's film. The table of options refers to these
// functions; options/option_store.h declares more of them.
#pragma once

#include "options/option_store.h"

#include <array>
#include <string>

namespace candelabra {

/// The name of a field of FilmSettings, or `film` itself, as a template argument.
struct FilmField {
    std::array<char, 16> text = {};

    consteval FilmField(const char* name) {  // NOLINT(google-explicit-constructor)
        for (char& c : text)
            if (*name != 0) c = *name++;
    }
};

/// Records a change of a field of the film; reports an invalid one.
void keep_film_change(std::string field, std::string value, Options&, const Given&, Diagnostics&);

namespace store {

template <FilmField field>
void film(Options& options, const Given& given, Diagnostics& diagnostics) {
    keep_film_change(field.text.data(), *given.value, options, given, diagnostics);
}
/// The value is `on`, `off`, or fields with their values.
void glare(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
