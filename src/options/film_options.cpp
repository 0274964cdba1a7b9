// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/film_options.h"

#include "text/message.h"

namespace candelabra {

void keep_film_change(std::string field, std::string value, Options& options, const Given& given,
                      Diagnostics& diagnostics) {
    FilmChange wanted{std::move(field), std::move(value)};
    FilmSettings any;
    const std::string wrong = change(any, wanted);
    if (wrong.empty())
        options.render.film.push_back(std::move(wanted));
    else
        refuse(given, diagnostics, wrong);
}

void store::glare(Options& options, const Given& given, Diagnostics& diagnostics) {
    std::string_view rest = *given.value;
    if (rest == "on" || rest == "off")
        return keep_film_change("glare", *given.value, options, given, diagnostics);
    do {
        const std::string_view one = take_until(rest, ",");
        const std::size_t sign = one.find('=');
        if (sign == one.npos)
            return refuse(given, diagnostics,
                          "glare is on, off, or fields with their values and commas between",
                          "--glare veil=0.2,star=0.05,blades=6");
        keep_film_change(message("glare.", one.substr(0, sign)), std::string(one.substr(sign + 1)),
                         options, given, diagnostics);
    } while (!rest.empty());
}

}  // namespace candelabra
