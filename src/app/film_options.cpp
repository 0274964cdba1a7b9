// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/film_options.h"

#include "text/message.h"

namespace candelabra {

namespace {

/// Keeps the change, if a film can have it.
void change_film(std::string name, const Given& given, std::string value, Options& options,
                 Diagnostics& diagnostics) {
    FilmChange wanted{std::move(name), std::move(value)};
    FilmSettings any;
    const std::string wrong = change(any, wanted);
    if (wrong.empty())
        options.render.film.push_back(std::move(wanted));
    else
        refuse(given, diagnostics, wrong);
}

}  // namespace

void store::film(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("film", given, *given.value, options, diagnostics);
}

void store::exposure(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("exposure", given, *given.value, options, diagnostics);
}

void store::white_balance(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("white_balance", given, *given.value, options, diagnostics);
}

void store::response(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("response", given, *given.value, options, diagnostics);
}

void store::pixel_filter(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("pixel_filter", given, *given.value, options, diagnostics);
}

void store::smooth_edges(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("smooth_edges", given, *given.value, options, diagnostics);
}

void store::glare(Options& options, const Given& given, Diagnostics& diagnostics) {
    std::string_view rest = *given.value;
    if (rest == "on" || rest == "off")
        return change_film("glare", given, *given.value, options, diagnostics);
    do {
        const std::string_view one = take_until(rest, ",");
        const std::size_t sign = one.find('=');
        if (sign == one.npos)
            return refuse(given, diagnostics,
                          "glare is on, off, or fields with their values and commas between",
                          "--glare veil=0.2,star=0.05,blades=6");
        change_film(message("glare.", one.substr(0, sign)), given,
                    std::string(one.substr(sign + 1)), options, diagnostics);
    } while (!rest.empty());
}

void store::vignette(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("vignette", given, *given.value, options, diagnostics);
}

void store::grain(Options& options, const Given& given, Diagnostics& diagnostics) {
    change_film("grain", given, *given.value, options, diagnostics);
}

}  // namespace candelabra
