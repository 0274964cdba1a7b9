// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/share_show.h"

#include "film/develop.h"
#include "output/light_file.h"
#include "picture/light_code.h"
#include "relight/page_frames.h"
#include "relight/page_records.h"
#include "relight/record_blocks.h"
#include "relight/record_file.h"
#include "relight/relighting.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// Frames before they are packed.
constexpr std::size_t most_frame_bytes = std::size_t{1} << 28;
/// Shares of a page: what its show may take, and its dots; and what a dot takes, packed.
constexpr double show_share = 0.75, dots_share = 0.3;
constexpr double bytes_of_dot = 3;

}  // namespace

std::size_t most_bytes_of_page(const Image& picture) {
    constexpr double usual_pixels = 1280.0 * 720;
    const double size =
        std::max(1.0, static_cast<double>(picture.width) * picture.height / usual_pixels);
    return static_cast<std::size_t>(size * static_cast<double>(most_page_bytes));
}

std::optional<SharedPicture> shared_show(const std::string& lights, const ShowFiles& files,
                                         const std::string& name, const Options& given,
                                         Diagnostics& diagnostics) {
    Options options = given;
    const auto fail = [&](std::string text, std::string help) {
        diagnostics.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
        return std::nullopt;
    };
    const auto records = read_records(lights, diagnostics);
    if (!records) return std::nullopt;
    LightShow show(records->lamps);
    if (!read_show(files, show, options, diagnostics)) return std::nullopt;
    const auto film = film_of(records->film, lights, options, diagnostics);
    if (!film) return std::nullopt;
    const auto frames = page_frames(show, most_frame_bytes);
    if (!frames)
        return fail(message("a show of ", show.frames(), " frames of ", records->lamps.size(),
                            " lamps is too long for a page"),
                    "fewer frames, or a film: candelabra relight --movie");
    const int threads = options.render.threads;
    const std::vector<Rgb> usual(records->lamps.size(), Rgb(1));
    const Image whole = relit(*records, usual, threads);
    const auto room = static_cast<double>(most_bytes_of_page(whole));
    SharedPicture made;
    made.title = made.name = name;
    made.film = *film;
    made.width = whole.width;
    made.height = whole.height;
    made.exposure = exposure_of({whole, {}, {}}, made.film);
    const PageRecords page = page_records(
        *records, made.film, static_cast<std::size_t>(dots_share * room / bytes_of_dot), threads);
    SharedShow& shared = made.show.emplace();
    shared.columns = page.columns;
    shared.rows = page.rows;
    shared.cell = page_cell;
    shared.strong = page.strong;
    shared.frames = frames->count;
    shared.rate = options.frame_rate;
    shared.scale = frames->scale;
    shared.grey = frames->grey;
    shared.sizes = {page.cells.size(), page.dots.size(), page.powers.size(), frames->bytes.size()};
    constexpr int effort = 9;
    shared.bytes = packed_by_zlib(page.cells + page.dots + page.powers + frames->bytes, effort);
    const double taken = static_cast<double>(shared.bytes.size()) * 4 / 3;
    if (taken > show_share * room)
        return fail(message("the show takes ", std::round(taken / 1e5) / 10,
                            " MB of a page, and there is room for ",
                            std::round(show_share * room / 1e5) / 10),
                    "fewer frames, or a smaller picture");
    for (const LampGroup& group : records->lamps.groups()) {
        shared.groups.push_back(group.lamps);
        if (made.lamps.size() < most_page_lamps) made.lamps.push_back(group.name);
    }
    if (shared.groups.size() > made.lamps.size())
        diagnostics.add(warning(Fault::option, {},
                                message("the page has sliders for ", made.lamps.size(), " of ",
                                        shared.groups.size(), " names of lamps"))
                            .with_help("light_name gives several lamps one name"));
    made.lamps.emplace_back("rest");
    made.light = light_code_within(page.layers,
                                   room_for_light(made, static_cast<std::size_t>(room)), threads);
    return made;
}

}  // namespace candelabra
