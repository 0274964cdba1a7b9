// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the options that change the camera's film. The table of options names these
// functions; more of the kind are in app/option_store.h.
#pragma once

#include "app/option_store.h"

#include <array>
#include <string>

namespace candelabra {

/// The name of a field of FilmSettings, or `film` itself, as an argument of a template.
struct FilmField {
    std::array<char, 16> text = {};

    consteval FilmField(const char* name) {  // NOLINT(google-explicit-constructor)
        for (char& c : text)
            if (*name != 0) c = *name++;
    }
};

/// Keeps the change of a field of the film, if a film can have it.
void keep_film_change(std::string field, std::string value, Options&, const Given&, Diagnostics&);

namespace store {

template <FilmField field>
void film(Options& options, const Given& given, Diagnostics& diagnostics) {
    keep_film_change(field.text.data(), *given.value, options, given, diagnostics);
}
/// `on`, `off`, or fields with their values.
void glare(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
