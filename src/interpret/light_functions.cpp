// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/light_functions.h"

#include "base/gamma.h"
#include "interpret/evaluator.h"
#include "photometry/light_colour.h"
#include "photometry/light_units.h"
#include "text/message.h"
#include "text/printable.h"

namespace candelabra {

namespace {

/// An amount of light of the first argument, which is at least 0.
Value light_amount(FunctionCall& call, double (LightUnits::*convert)(double) const,
                   double factor = 1) {
    const double amount = call.number(0);
    if (call.failed()) return Absence::broken;
    if (!(amount >= 0))
        return call.fail(Fault::out_of_range, 0,
                         message("an amount of light must be at least 0, but this is ", amount));
    return (call.world.evaluator->use_light_units().*convert)(amount * factor);
}

/// A colour in the gamma of the scene's colours.
Value as_colour_of_scene(FunctionCall& call, Rgb rgb) {
    const double gamma = call.world.evaluator->working_gamma();
    for (int channel = 0; channel < 3; ++channel) rgb[channel] = from_linear(rgb[channel], gamma);
    return Numbers::vector(vec3_of(rgb));
}

bool within(FunctionCall& call, double low, double high, std::string_view what) {
    const double given = call.number(0);
    if (call.failed() || (given >= low && given <= high)) return !call.failed();
    call.fail(Fault::out_of_range, 0,
              message(what, " must be between ", low, " and ", high, ", but this is ", given));
    return false;
}

}  // namespace

Value light_of_lumens(FunctionCall& call) { return light_amount(call, &LightUnits::flux); }
Value light_of_candela(FunctionCall& call) { return light_amount(call, &LightUnits::intensity); }
Value light_of_lux(FunctionCall& call) { return light_amount(call, &LightUnits::colour); }
Value light_of_nits(FunctionCall& call) { return light_amount(call, &LightUnits::radiance); }

Value light_of_watts(FunctionCall& call) {
    const double efficacy = call.number(1);
    if (!call.failed() && !(efficacy > 0 && efficacy <= 683))
        return call.fail(Fault::out_of_range, 1,
                         message("the efficacy, in lumens per watt, must be above 0 and at most "
                                 "683, but this is ",
                                 efficacy));
    return light_amount(call, &LightUnits::flux, efficacy);
}

Value colour_of_kelvin(FunctionCall& call) {
    bool daylight = false;
    if (call.count() > 1) {
        const std::string_view locus = call.text(1);
        if (call.failed()) return Absence::broken;
        daylight = locus == "daylight";
        if (!daylight && locus != "planck")
            return call.fail(Fault::unknown_word, 1,
                             message("`", printable(locus),
                                     "` is no kind of light here; there are \"planck\" "
                                     "(a glowing body) and \"daylight\""));
    }
    if (!within(call, daylight ? min_daylight : min_planck, daylight ? max_daylight : max_planck,
                daylight ? "the temperature of daylight" : "the temperature"))
        return Absence::broken;
    const double kelvin = call.number(0);
    return as_colour_of_scene(call, daylight ? daylight_colour(kelvin) : planck_colour(kelvin));
}

Value colour_of_wavelength(FunctionCall& call) {
    if (!within(call, min_wavelength, max_wavelength, "the wavelength, in nanometres,"))
        return Absence::broken;
    return as_colour_of_scene(call, spectral_colour(call.number(0)));
}

}  // namespace candelabra
