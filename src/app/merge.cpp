// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/merge.h"

#include "app/option_store.h"
#include "app/output.h"
#include "picture/file.h"
#include "text/harmless.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <set>

namespace {

class Joiner {
public:
    Joiner(std::vector<NamedState> states, Gaps gaps, Diagnostics& diagnostics)
        : states_(std::move(states)), gaps_(gaps), diagnostics_(diagnostics) {}

    std::optional<Checkpoint> operator()() {
        std::ranges::stable_sort(states_, {}, [](const NamedState& state) {
            const Share& share = state.checkpoint.state.share;
            return std::pair(share.first_sample, share.first_tile);
        });
        for (const NamedState& state : states_) compare(state);
        if (diagnostics_.failed()) return std::nullopt;
        if (first().state.share.tile_step > 1)
            check_tiles();
        else
            check_samples();
        if (diagnostics_.failed()) return std::nullopt;
        return sum();
    }

private:
    const Checkpoint& first() const { return states_.front().checkpoint; }

    void refuse(std::string text) { diagnostics_.add(error(Fault::option, {}, std::move(text))); }

    /// `least`: from which on it may be.
    void missing(const std::string& what, Gaps least) {
        if (gaps_ >= least)
            diagnostics_.add(warning(Fault::option, {}, what));
        else
            diagnostics_.add(error(Fault::option, {}, what)
                                 .with_help(gaps_ == Gaps::none
                                                ? "--partial makes a picture of what there is"
                                                : "a picture can have such a gap, a state cannot"));
    }

    void compare(const NamedState& state) {
        const Checkpoint& one = state.checkpoint;
        const auto mixed = [&](const std::string& why) {
            refuse(message("`", harmless(state.name), "` does not belong to `",
                           harmless(states_.front().name), "`: ", why));
        };
        std::string different = difference(first().identity, one.identity);
        if (different.empty()) different = difference(one.identity, first().identity);
        if (!different.empty()) return mixed(different);
        if (one.all_samples != first().all_samples)
            return mixed(message("it is of a picture with ", one.all_samples, " samples, not ",
                                 first().all_samples));
        const Film& film = one.state.film;
        const Film& other = first().state.film;
        const Share &a = one.state.share, &b = first().state.share;
        if (film.width() != other.width() || film.height() != other.height() ||
            film.extras() != other.extras() || a.tile_step != b.tile_step || a.region != b.region)
            return mixed("the picture was cut in another way");
        if (!one.finished)
            missing(message("`", harmless(state.name), "` is not finished"), Gaps::around);
    }

    void check_tiles() {
        const int count = first().state.share.tile_step;
        std::set<int> found;
        for (const NamedState& state : states_) {
            const int number = state.checkpoint.state.share.first_tile;
            if (!found.insert(number).second)
                refuse(message("shard ", number + 1, " of ", count, " is there twice: `",
                               harmless(state.name), "`"));
        }
        for (int i = 0; i < count; ++i)
            if (!found.count(i))
                missing(message("shard ", i + 1, " of ", count, " is missing"), Gaps::anywhere);
    }

    void check_samples() {
        std::uint32_t end = 0;
        const auto gap = [&](std::uint32_t from, std::uint32_t to, Gaps least) {
            if (from < to)
                missing(message("samples ", from, " to ", to - 1, " of 0 to ",
                                first().all_samples - 1, " are missing"),
                        least);
        };
        for (const NamedState& state : states_) {
            const std::uint32_t begin = state.checkpoint.state.share.first_sample;
            if (begin < end && state.checkpoint.samples > 0)
                refuse(message("`", harmless(state.name), "` has samples from ", begin,
                               " on, of which another shard has some, too"));
            gap(end, begin, &state == &states_.front() ? Gaps::around : Gaps::anywhere);
            end = std::max(end, begin + state.checkpoint.samples);
        }
        gap(end, first().all_samples, Gaps::around);
    }

    Checkpoint sum() const {
        Checkpoint result = first();
        Film& film = result.state.film;
        film = Film(film.width(), film.height(), film.extras());
        result.samples = 0;
        for (const NamedState& state : states_) {
            const RenderState& part = state.checkpoint.state;
            for (int y = 0; y < part.film.height(); ++y)
                for (int x = 0; x < part.film.width(); ++x)
                    // A shard of tiles also has samples around its tiles.
                    if (part.share.owns(x, y)) {
                        film.add(film.index(x, y), part.film);
                        film.at(x, y).target += part.film.at(x, y).target;
                    }
            result.samples += state.checkpoint.samples;
            result.finished &= state.checkpoint.finished;
        }
        if (result.state.share.tile_step > 1) result.samples = result.all_samples;
        result.state.share.first_tile = 0;
        result.state.share.tile_step = 1;
        return result;
    }

    std::vector<NamedState> states_;
    Gaps gaps_;
    Diagnostics& diagnostics_;
};

struct Request {
    Options options;
    std::vector<std::string> files;
    bool partial = false;
};

/// Whether an option, as in an INI file, can change what merge does.
bool matters(std::string_view given) {
    static constexpr auto all = std::to_array<std::string_view>(
        {"Output_File_Name=", "Output_File_Type=", "+F", "Bits_Per_Color=", "Grayscale_Output=",
         "Verbose=", "--diagnostics=", "--warn=", "Warning_Level=", "Input_File_Name="});
    return std::ranges::any_of(all, [&](std::string_view each) { return given.starts_with(each); });
}

Request read_request(std::span<const std::string_view> arguments, Diagnostics& diagnostics) {
    Request request;
    std::vector<std::string_view> others;
    for (const std::string_view argument : arguments) {
        const bool file = argument.ends_with(state_ending) && !argument.starts_with('+');
        if (argument == "--partial")
            request.partial = true;
        else if (file)
            request.files.emplace_back(argument);
        else
            others.push_back(argument);
    }
    request.options = read_options(others, diagnostics);
    for (const std::string& given : request.options.given)
        if (!matters(given))
            diagnostics.add(warning(Fault::option, {},
                                    message("`", harmless(given),
                                            "` is ignored: how the picture is made, its states "
                                            "say")));
    if (request.options.scene)
        diagnostics.add(error(Fault::option, {},
                              message("`", harmless(*request.options.scene),
                                      "` is no state of a picture; those end in ", state_ending)));
    if (request.options.task != Task::render)
        diagnostics.add(
            error(Fault::option, {}, "merge makes a picture or a state and nothing else")
                .with_help("man candelabra-merge"));
    else if (request.files.empty())
        diagnostics.add(error(Fault::option, {}, "merge needs the states of shards")
                            .with_help("candelabra merge +Opicture.png picture.png.*.state.exr"));
    return request;
}

/// Where the picture goes when nothing is said: the shards' name without what makes them shards.
std::string usual_output(std::string file) {
    file.resize(file.size() - state_ending.size());
    const std::size_t dot = file.rfind('.');
    const bool shard = dot != file.npos && file.find("of", dot) != file.npos;
    return shard ? file.substr(0, dot) : file;
}

bool makes_state(const Request& request) { return request.options.output.ends_with(state_ending); }

bool write_result(const Request& request, const Checkpoint& result, Diagnostics& diagnostics) {
    Options options = request.options;
    if (makes_state(request)) {
        const auto bytes = encode(result, diagnostics);
        return bytes && write_file(options.output, *bytes, diagnostics);
    }
    if (options.output.empty()) options.output = usual_output(request.files.front());
    FilmFiles files;
    tell_layers(result.identity, files);
    options.alpha = files.alpha;
    options.layers = files.layers;
    Output output = output_of(options, diagnostics);
    if (diagnostics.failed()) return false;
    output.format.gamma = number(fact(result.identity, "gamma")).value_or(1);
    output.format.encoded = fact(result.identity, "encoded") == "yes";
    output.format.file_gamma = number(fact(result.identity, "file_gamma")).value_or(-1);
    output.format.description = description(result.identity, static_cast<int>(result.samples));
    files.path = output.path;
    files.format = output.format;
    return write_film(result.state.film, files, diagnostics);
}

}  // namespace

std::optional<Checkpoint> joined(std::vector<NamedState> states, Gaps gaps,
                                 Diagnostics& diagnostics) {
    return Joiner(std::move(states), gaps, diagnostics)();
}

int merge(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    const Request request = read_request(arguments, diagnostics);
    const auto end = [&](int status) {
        say_errors(console, request.options, diagnostics);
        return status;
    };
    if (diagnostics.failed()) return end(exit_status::usage);
    std::vector<NamedState> states;
    for (const std::string& file : request.files)
        if (auto checkpoint = read_checkpoint(file, diagnostics))
            states.push_back({file, std::move(*checkpoint)});
    if (diagnostics.failed()) return end(exit_status::file);
    const Gaps gaps = !request.partial       ? Gaps::none
                      : makes_state(request) ? Gaps::around
                                             : Gaps::anywhere;
    const auto result = joined(std::move(states), gaps, diagnostics);
    if (!result) return end(exit_status::usage);
    return end(write_result(request, *result, diagnostics) ? exit_status::done : exit_status::file);
}
