// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/light_weights.h"

#include "base/colour.h"
#include "interpret/csv.h"
#include "text/ascii.h"
#include "text/decimal.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

namespace candelabra {

namespace {

using WeightJson = nlohmann::ordered_json;

constexpr std::size_t max_file_bytes = std::size_t{64} << 20;
constexpr std::string_view weight_rule =
    "a weight is a number from 0 on, a colour, or both: 4, #ff8800, or 4,#ff8800";

std::optional<Rgb> colour_of(std::string_view text) {
    if (!text.starts_with('#') || (text.size() != 4 && text.size() != 7) ||
        !std::ranges::all_of(text.substr(1), is_hex_digit))
        return std::nullopt;
    const auto encoded = csv_colour(text);
    return Rgb(srgb_decode(encoded[0]), srgb_decode(encoded[1]), srgb_decode(encoded[2]));
}

std::optional<double> strength_of(std::string_view text) {
    const std::optional<double> value = finite_number(text);
    return value && *value >= 0 ? value : std::nullopt;
}

/// The factor that JSON gives a lamp: a number, a text, or an object.
std::optional<Rgb> factor_in(const WeightJson& json) {
    if (json.is_string()) return lamp_factor(json.get<std::string>());
    if (json.is_number()) {
        const auto strength = json.get<double>();
        return strength >= 0 ? std::optional(Rgb(strength)) : std::nullopt;
    }
    if (!json.is_object() || json.empty()) return std::nullopt;
    Rgb factor(1);
    for (const auto& [name, value] : json.items()) {
        const bool colour = name == "colour" || name == "color";
        if (!(colour ? value.is_string() : name == "strength" && value.is_number()))
            return std::nullopt;
        const auto part = factor_in(value);
        if (!part) return std::nullopt;
        factor *= *part;
    }
    return factor;
}

void set(LightFactors& factors, std::string name, const Rgb& factor) {
    const auto found = std::ranges::find(factors, name, &LightFactors::value_type::first);
    if (found != factors.end())
        found->second = factor;
    else
        factors.emplace_back(std::move(name), factor);
}

bool fail_to_weigh(std::string text, std::string help, Diagnostics& diagnostics) {
    diagnostics.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
    return false;
}

}  // namespace

std::optional<Rgb> lamp_factor(std::string_view text) {
    std::optional<double> strength;
    std::optional<Rgb> colour;
    constexpr std::string_view gaps = ", \t";
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(gaps), text.size()));
        if (text.empty()) break;
        const std::string_view word = text.substr(0, text.find_first_of(gaps));
        text.remove_prefix(word.size());
        if (word.starts_with('#') ? colour.has_value() : strength.has_value()) return std::nullopt;
        if (word.starts_with('#'))
            colour = colour_of(word);
        else
            strength = strength_of(word);
        if (!(word.starts_with('#') ? colour.has_value() : strength.has_value()))
            return std::nullopt;
    }
    if (!strength && !colour) return std::nullopt;
    return strength.value_or(1) * colour.value_or(Rgb(1));
}

bool LightWeights::add(std::string_view text, Diagnostics& diagnostics) {
    const std::size_t equals = text.rfind('=');
    const auto factor =
        equals == text.npos || equals == 0 ? std::nullopt : lamp_factor(text.substr(equals + 1));
    if (!factor)
        return fail_to_weigh(message("`--light ", printable(text), "` is no lamp with its weight"),
                             "--light Lamp=0.5, --light Lamp=#ff8800, or --light Lamp=4,#ff8800",
                             diagnostics);
    set(given_, std::string(text.substr(0, equals)), *factor);
    return true;
}

bool LightWeights::read(const std::string& path, Diagnostics& diagnostics) {
    const auto text = content_of_file(path, max_file_bytes);
    if (!text) {
        diagnostics.add(error(Fault::io, {}, message("`", printable(path), "` cannot be read")));
        return false;
    }
    const bool json = lower_case(std::filesystem::path(path).extension().string()) == ".json";
    return json ? read_json(path, *text, diagnostics) : read_table(path, *text, diagnostics);
}

bool LightWeights::read_json(const std::string& path, const std::string& text,
                             Diagnostics& diagnostics) {
    const WeightJson json = WeightJson::parse(text, nullptr, false);
    const std::string form =
        "{ \"Top\": 4, \"Bottom\": \"0.1,#ff8800\" }, or a list of such "
        "objects, one for each frame";
    const auto take = [&](const WeightJson& frame) {
        if (!frame.is_object())
            return fail_to_weigh(message("`", printable(path), "` has no lamps with weights"), form,
                                 diagnostics);
        LightFactors factors;
        for (const auto& [name, weight] : frame.items()) {
            const auto factor = factor_in(weight);
            if (!factor)
                return fail_to_weigh(message("`", printable(path), "`: the weight of `",
                                             printable(name), "` is none"),
                                     std::string(weight_rule), diagnostics);
            set(factors, name, *factor);
        }
        frames_.push_back(std::move(factors));
        return true;
    };
    by_frame_ = json.is_array() && !json.empty();
    if (!by_frame_) return take(json);
    return std::ranges::all_of(json, take);
}

bool LightWeights::read_table(const std::string& path, std::string_view text,
                              Diagnostics& diagnostics) {
    CsvForm form;
    form.header = CsvForm::Header::there;
    form.text = true;
    CsvProblem problem;
    const auto table = read_csv(text, form, max_file_bytes, problem);
    const auto line =
        1 +
        std::count(text.begin(),
                   text.begin() + static_cast<std::ptrdiff_t>(std::min(problem.first, text.size())),
                   '\n');
    if (!table)
        return fail_to_weigh(message("`", printable(path), "`, line ", line, " ",
                                     problem.too_many ? "has too many cells" : problem.message),
                             "the first row names lamps, and each other row is a frame",
                             diagnostics);
    for (std::size_t row = 0; row < table->rows; ++row) {
        LightFactors factors;
        for (std::size_t column = 0; column < table->columns; ++column) {
            const std::string& name = table->names[column];
            const std::string& cell = table->cells[row * table->columns + column];
            if (lower_case(name) == "frame" || cell.empty()) continue;
            const auto factor = lamp_factor(std::string_view(cell));
            if (!factor)
                return fail_to_weigh(
                    message("`", printable(path), "`: the weight of `", printable(name),
                            "` in frame ", row + 1, " is `", printable(cell), "`"),
                    std::string(weight_rule), diagnostics);
            set(factors, name, *factor);
        }
        frames_.push_back(std::move(factors));
    }
    by_frame_ = true;
    return true;
}

LightFactors LightWeights::of(std::size_t frame) const {
    LightFactors factors;
    if (!frames_.empty()) factors = frames_[by_frame_ ? frame : 0];
    for (const auto& [name, factor] : given_) set(factors, name, factor);
    return factors;
}

void relight(Image& picture, std::span<const LampLight> lamps) {
    constexpr double rounding = 2 * std::numeric_limits<float>::epsilon();
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        Rgb sum = picture.pixels[i], size = abs(sum);
        for (const LampLight& lamp : lamps) {
            if (lamp.factor == Rgb(1)) continue;
            const Rgb more = (lamp.factor - Rgb(1)) * lamp.light.pixels[i];
            sum += more;
            size += abs(more);
        }
        if (sum == picture.pixels[i]) continue;
        for (int c = 0; c < 3; ++c)
            picture.pixels[i][c] = std::abs(sum[c]) <= rounding * size[c] ? 0 : sum[c];
    }
}

}  // namespace candelabra
