// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/answers.h"

#include "base/number_text.h"
#include "output/light_report.h"
#include "preview/inspect.h"
#include "preview/page_files.h"
#include "text/message.h"
#include "web/static_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace candelabra {

namespace {

constexpr auto plain = "text/plain; charset=utf-8";

WebAnswer no_such_page() { return {plain, "no such page\n", 404}; }
WebAnswer done() { return {plain, ""}; }
WebAnswer refuse(std::string_view why) { return {plain, message(why, "\n"), 400}; }

template <class Number>
std::optional<Number> number_in(const WebRequest& request, std::string_view name) {
    const std::string text = request.parameter(name);
    Number value{};
    const auto [end, problem] = number_from(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>)
        if (!std::isfinite(value)) return std::nullopt;
    return value;
}

/// Parses several numbers; returns nothing unless all are present.
template <std::size_t count>
std::optional<std::array<double, count>> numbers_in(
    const WebRequest& request, const std::array<std::string_view, count>& names) {
    std::array<double, count> values{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = number_in<double>(request, names[i]);
        if (!value) return std::nullopt;
        values[i] = *value;
    }
    return values;
}

// Requests that change something.

WebAnswer turn(const WebRequest& request, PreviewState& state) {
    if (state.turn(request.parameter("name"), request.parameter("value"))) return done();
    return {plain, "there is no such knob or value\n", 404};
}

WebAnswer develop_by(const WebRequest& request, PreviewState& state) {
    const FilmChange wanted{request.parameter("name"), request.parameter("value")};
    if (wanted.name == "reset") {
        state.reset_film();
        return done();
    }
    const std::string wrong = state.change_film(wanted);
    return wrong.empty() ? done() : refuse(wrong);
}

WebAnswer dim(const WebRequest& request, PreviewState& state) {
    if (request.parameter("reset") == "all") {
        state.reset_lamps();
        return done();
    }
    const auto lamp = number_in<std::size_t>(request, "lamp");
    auto values = numbers_in<4>(request, {"strength", "red", "green", "blue"});
    if (!lamp || !values) return refuse("a lamp has a strength, red, green and blue");
    constexpr double greatest = 1000;
    for (double& value : *values) value = std::clamp(value, 0.0, greatest);
    const auto [strength, red, green, blue] = *values;
    return state.dim(*lamp, {strength, {red, green, blue}}) ? done() : no_such_page();
}

WebAnswer look(const WebRequest& request, PreviewState& state) {
    const std::string quiet = request.parameter("denoise"), name = request.parameter("view");
    if (quiet == "on" || quiet == "off") {
        state.denoise(quiet == "on");
        return done();
    }
    return state.choose_view(name) ? done() : refuse("there is no such view");
}

/// Changes the camera by degrees, fractions of the picture, and factors. Their ranges are those of
/// one gesture.
WebAnswer orbit(const WebRequest& request, PreviewState& state) {
    constexpr double most = 1000;
    if (request.parameter("reset") == "all") {
        state.move_camera([](Orbit& moved, const Sight&) { moved.reset(); });
        return done();
    }
    const auto values = numbers_in<2>(request, {"right", "up"});
    const auto factor = number_in<double>(request, "approach");
    const std::string way = request.parameter("by");
    if (factor && *factor > 0) {
        state.move_camera([&](Orbit& moved, const Sight&) { moved.approach(*factor); });
        return done();
    }
    if (!values || std::abs((*values)[0]) > most || std::abs((*values)[1]) > most)
        return refuse("a camera is moved by=turn or by=pan, right and up, or to approach");
    const double right = (*values)[0], up = (*values)[1];
    if (way == "turn")
        state.move_camera([&](Orbit& moved, const Sight& given) { moved.turn(given, right, up); });
    else if (way == "pan")
        state.move_camera([&](Orbit& moved, const Sight& given) { moved.pan(given, right, up); });
    else
        return refuse("a camera is moved by=turn or by=pan");
    return done();
}

WebAnswer point(const WebRequest& request, PreviewState& state) {
    const auto place = numbers_in<2>(request, {"x", "y"});
    if (!place) return refuse("a place has x and y, from 0 to 1");
    state.point_at({std::clamp((*place)[0], 0.0, 1.0), std::clamp((*place)[1], 0.0, 1.0)});
    return done();
}

WebAnswer pause(const WebRequest& request, PreviewState& state) {
    state.pause(request.parameter("on") == "yes");
    return done();
}

struct Address {
    std::string_view path;
    WebAnswer (*answer)(const WebRequest&, PreviewState&);
};
constexpr auto changing = std::to_array<Address>({{"/turn", turn},
                                                  {"/develop", develop_by},
                                                  {"/dim", dim},
                                                  {"/look", look},
                                                  {"/orbit", orbit},
                                                  {"/point", point},
                                                  {"/pause", pause}});

// Requests that return data.

/// Returns the picture for a canvas: five little-endian 32-bit integers, then its pixels.
WebAnswer screen(const PreviewState& state) {
    const ScreenPicture picture = state.picture();
    if (!picture.bytes) return no_such_page();
    std::string bytes;
    for (const int number :
         {picture.width, picture.height, picture.columns, picture.rows, picture.generation})
        for (int shift = 0; shift < 32; shift += 8)
            bytes += static_cast<char>(static_cast<std::uint32_t>(number) >> shift);
    return {"application/octet-stream", bytes + *picture.bytes};
}

WebAnswer file(const PreviewState& state, const PreviewFacts& facts, bool exr, bool saved) {
    std::string bytes = state.picture_file(exr);
    if (bytes.empty()) return no_such_page();
    const std::string name = std::filesystem::path(facts.scene).stem().string();
    return {exr ? "image/x-exr" : "image/png", std::move(bytes), 200,
            saved ? message(name, exr ? ".exr" : ".png") : std::string()};
}

WebAnswer status(const WebRequest& request, const PreviewState& state) {
    const auto since = number_in<int>(request, "since");
    if (since && *since == state.version()) {
        WebAnswer nothing{"application/json", state.status()};
        nothing.later = true;
        return nothing;
    }
    return {"application/json", state.status()};
}

WebAnswer pick(const WebRequest& request, PreviewState& state) {
    const int x = number_in<int>(request, "x").value_or(-1);
    const int y = number_in<int>(request, "y").value_or(-1);
    return {plain, state.questions().ask([=](const RenderedPicture& picture) {
                return what_is_under(picture, x, y);
            })};
}

WebAnswer report(PreviewState& state) {
    return {plain, state.questions().ask([](const RenderedPicture& picture) {
                return light_report(*picture.shot.world, picture.rays, picture.sources);
            })};
}

constexpr std::string_view manual_path = "/manual";
constexpr auto manual_entrance =
    "<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><title>Candelabra</title>"
    "<meta http-equiv=\"refresh\" content=\"0; url=/manual/\">"
    "<a href=\"/manual/\">The manual</a></html>\n";
constexpr auto manual_missing =
    "<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\">"
    "<meta name=\"viewport\" content=\"width=device-width\"><title>Candelabra</title>"
    "<style>body { font: 16px/1.5 system-ui, sans-serif; max-width: 40rem; margin: 4rem auto; "
    "padding: 0 1rem; color-scheme: light dark; } pre { padding: 1rem; border: 1px solid #8886; "
    "border-radius: 6px; }</style><h1>The manual is not built yet</h1>"
    "<p>It is made in the folder in which the program was built, and takes some minutes:</p>"
    "<pre>cmake --build build --target book</pre>"
    "<p>Its pages are also there as <code>man candelabra</code>, "
    "<code>man candelabra-tutorial</code> and <code>man candelabra-scene</code>.</p>"
    "<p><a href=\"/\">Back to the picture</a></p></html>\n";

WebAnswer manual(std::string_view path, const PreviewFacts& facts) {
    constexpr auto html = "text/html; charset=utf-8";
    if (facts.manual.empty()) return {html, manual_missing, 404};
    if (path == manual_path) return {html, manual_entrance};
    return static_file(facts.manual, path.substr(manual_path.size() + 1));
}

}  // namespace

std::string page_with(const std::string& token, const std::string& scene) {
    std::string page(preview_page);
    page.replace(page.find(token_place), token_place.size(), token);
    std::string safe;
    for (const char c : std::filesystem::path(scene).filename().string())
        safe += c == '<' || c == '>' || c == '&' || c == '"' || c == '\'' ? '_' : c;
    for (std::size_t at = page.find(scene_place); at != page.npos;
         at = page.find(scene_place, at + safe.size()))
        page.replace(at, scene_place.size(), safe);
    return page;
}

std::string manual_folder(const std::string& program_folder) {
    for (const char* place : {"manual", "../share/doc/candelabra/manual"}) {
        const auto folder = (std::filesystem::path(program_folder) / place).lexically_normal();
        std::error_code none;
        if (std::filesystem::is_regular_file(folder / "index.html", none)) return folder.string();
    }
    return {};
}

WebAnswer answer_of(const WebRequest& request, const PreviewFacts& facts, PreviewState& state) {
    const std::string& path = request.path;
    const auto address = std::ranges::find(changing, path, &Address::path);
    // A link must not change anything, so changes need POST.
    if (request.post != (address != changing.end()))
        return {plain, "what changes something is for POST, all else for GET\n", 405};
    if (address != changing.end()) return address->answer(request, state);
    if (path == "/") return {"text/html; charset=utf-8", facts.page};
    if (path == "/style.css") return {"text/css; charset=utf-8", std::string(preview_style)};
    if (path == "/page.js") return {"text/javascript; charset=utf-8", std::string(preview_script)};
    // Browsers ask for the second one where a page is plain text.
    if (path == "/icon.svg" || path == "/favicon.ico")
        return {"image/svg+xml", std::string(preview_icon)};
    if (path == "/status") return status(request, state);
    if (path == "/picture") return screen(state);
    if (path == "/picture.png") return file(state, facts, false, false);
    if (path == "/save.png") return file(state, facts, false, true);
    if (path == "/save.exr") return file(state, facts, true, true);
    if (path == "/pick") return pick(request, state);
    if (path == "/report") return report(state);
    if (path == "/camera") return {plain, state.camera()};
    if (path == "/film") return {plain, state.film()};
    if (path == manual_path || path.starts_with("/manual/")) return manual(path, facts);
    return no_such_page();
}

}  // namespace candelabra
