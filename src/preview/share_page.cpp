// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/share_page.h"

#include "base/elementary.h"
#include "film/auto_exposure.h"
#include "film/response.h"
#include "film/white_balance.h"
#include "preview/page_files.h"

#include <nettle/base64.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <utility>

namespace candelabra {

namespace {

using PageJson = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
    std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
    base64_encode_raw(text.data(), bytes.size(),
                      reinterpret_cast<const std::uint8_t*>(bytes.data()));
    return text;
}

std::string as_html(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '&')
            safe += "&amp;";
        else if (c == '"')
            safe += "&quot;";
        else
            safe += code < ' ' ? ' ' : c;
    }
    return safe;
}

/// JSON that may stand within a script of a page: nothing in it ends the script or begins a
/// comment.
std::string within_script(const PageJson& json) {
    std::string safe;
    for (const char c : json.dump(-1, ' ', true, PageJson::error_handler_t::replace))
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    return safe;
}

/// The curve of a response at exposures whose logarithms to the base 2 are evenly spaced.
PageJson curve_json(double (*curve)(double)) {
    constexpr int first = -16, last = 12, parts = 16;
    PageJson values = PageJson::array();
    for (int i = 0; i <= (last - first) * parts; ++i)
        values.push_back(
            static_cast<float>(curve(math::exp2(first + static_cast<double>(i) / parts))));
    return {{"first", first}, {"step", 1.0 / parts}, {"values", values}};
}

PageJson film_json(const SharedPicture& picture) {
    const FilmSettings& film = picture.film;
    PageJson json = {{"exposure", picture.exposure},
                     {"response", film.response},
                     {"contrast", film.contrast},
                     {"saturation", film.saturation}};
    PageJson& luminance = json["luminance"];
    for (const Rgb& primary : {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1)})
        luminance.push_back(srgb_luminance(primary));
    if (film.white_balance != 0) {
        const ColourMatrix matrix = white_balance(film.white_balance);
        for (const Vec3& row : {matrix.red, matrix.green, matrix.blue})
            for (int c = 0; c < 3; ++c) json["balance"].push_back(row[c]);
    }
    if (film.curve() == ResponseCurve::filmic) json["curve"] = curve_json(filmic_curve);
    if (film.curve() == ResponseCurve::agx) {
        json["curve"] = curve_json(agx_curve);
        json["agx"] = {{"mixed_in", agx_mixing.mixed_in},
                       {"taken_back", agx_mixing.taken_back},
                       {"kept_in_proportion", agx_mixing.kept_in_proportion},
                       {"half_kept_exposure", agx_mixing.half_kept_exposure}};
    }
    return json;
}

PageJson facts_json(const SharedPicture& picture) {
    PageJson shown = PageJson::array();
    for (const std::string& lamp : picture.lamps)
        shown.push_back(lamp == "rest" ? "Other light" : lamp);
    PageJson json = {{"name", picture.name},       {"width", picture.width},
                     {"height", picture.height},   {"lamps", shown},
                     {"names", picture.lamps},     {"levels", picture.light.levels},
                     {"step", picture.light.step}, {"gain", light_code_gain},
                     {"film", film_json(picture)}};
    if (picture.show) {
        const SharedShow& show = *picture.show;
        json["show"] = {{"columns", show.columns}, {"rows", show.rows},     {"cell", show.cell},
                        {"groups", show.groups},   {"strong", show.strong}, {"frames", show.frames},
                        {"rate", show.rate},       {"scale", show.scale},   {"grey", show.grey},
                        {"sizes", show.sizes}};
    }
    if (picture.watched > 0) json["watched"] = picture.watched;
    return json;
}

}  // namespace

std::string share_page(const SharedPicture& picture) {
    const std::pair<std::string_view, std::string> parts[] = {
        {"SOURCES-OF-THE-PAGE", picture.watched > 0 ? "; connect-src 'self'" : ""},
        {"TITLE-OF-THE-PAGE", as_html(picture.title)},
        {"ICON-OF-THE-PAGE", base64(preview_icon)},
        {"STYLE-OF-THE-PAGE", std::string(share_style)},
        {"DATA-OF-THE-PAGE", within_script(facts_json(picture))},
        {"LIGHT-OF-THE-PAGE", base64(picture.light.bytes)},
        {"SHOW-OF-THE-PAGE", base64(picture.show ? picture.show->bytes : std::string())},
        {"SCRIPT-OF-THE-PAGE",
         std::string(share_script).append(picture.watched > 0 ? share_watch : "")}};
    // Places are searched in the frame alone, so that no title can name one.
    std::string page;
    std::string_view frame = share_frame;
    while (true) {
        std::size_t next = frame.npos;
        const std::pair<std::string_view, std::string>* found = nullptr;
        for (const auto& part : parts)
            if (const std::size_t at = frame.find(part.first); at < next) {
                next = at;
                found = &part;
            }
        if (!found) break;
        page.append(frame.substr(0, next)).append(found->second);
        frame.remove_prefix(next + found->first.size());
    }
    return page.append(frame);
}

std::size_t room_for_light(const SharedPicture& picture, std::size_t page_bytes) {
    SharedPicture dark = picture;
    dark.light.bytes.clear();
    // Numbers of the code itself, which is not made yet.
    constexpr std::size_t more = 64;
    const std::size_t frame = share_page(dark).size() + more;
    return page_bytes > frame ? (page_bytes - frame) / 4 * 3 : 0;
}

}  // namespace candelabra
