// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/merge.h"

#include "app/sandbox.h"
#include "options/option_store.h"
#include "options/output.h"
#include "options/subcommands.h"
#include "output/layers.h"
#include "picture/file.h"
#include "production/checkpoint.h"
#include "relight/light_recorder.h"
#include "tasks/kept_lights.h"
#include "text/message.h"
#include "text/printable.h"
#include "transport/aovs.h"

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// The gaps that are tolerated; they are reported in any case.
enum class Gaps {
    none,
    around,    ///< samples before and after the present ones, as in a state
    anywhere,  ///< as in a picture
};

/// Adds up states of the same picture. Reports states of other pictures, overlaps and gaps.
class Joiner {
public:
    Joiner(Gaps gaps, Diagnostics& diagnostics) : gaps_(gaps), diagnostics_(diagnostics) {}

    void add(const std::string& name, const Checkpoint& state) {
        parts_.push_back(
            {name, state.state.shard, state.state.rounds, state.samples, state.finished});
        if (parts_.size() == 1)
            begin(state);
        else
            compare(name, state);
        if (!state.finished)
            missing(message("`", printable(name), "` is not finished"), Gaps::around);
        if (!diagnostics_.failed()) sum_up(state);
        if (!diagnostics_.failed()) join_lamps(name, state);
    }

    /// What the states have kept of the light of lamps; null if one of them has kept none.
    const LightRecorder* lamps() const { return lamps_.get(); }

    /// Describes the states, one a line. Precondition: at least one state was added.
    std::string report() const {
        std::string text;
        for (const Part& part : parts_) {
            const PictureShard& its = part.shard;
            text += message(printable(part.name), ": ");
            if (its.tile_step > 1)
                text += message("part ", its.first_tile + 1, " of ", its.tile_step, " by tiles");
            else
                text += message("samples ", its.first_sample, " to ",
                                its.first_sample + std::max(part.samples, 1u) - 1, " of 0 to ",
                                sum_.all_samples - 1);
            text += part.finished ? ", finished\n" : ", not finished\n";
        }
        return text;
    }

    /// Returns the sum, or nothing after an error. Precondition: at least one state was added.
    std::optional<Checkpoint> finish() {
        std::ranges::stable_sort(parts_, {}, [](const Part& part) {
            return std::pair(part.shard.first_sample, part.shard.first_tile);
        });
        if (!diagnostics_.failed()) {
            if (shard().tile_step > 1)
                check_tiles();
            else
                check_samples();
        }
        if (diagnostics_.failed()) return std::nullopt;
        if (shard().tile_step > 1) sum_.samples = sum_.all_samples;
        sum_.state.rounds = parts_.front().rounds;
        sum_.state.shard.first_sample = parts_.front().shard.first_sample;
        sum_.state.shard.first_tile = 0;
        sum_.state.shard.tile_step = 1;
        if (lamps_) sum_.lamps = lamps_->state(0);
        return std::move(sum_);
    }

private:
    struct Part {
        std::string name;
        PictureShard shard;
        std::uint32_t rounds, samples;
        bool finished;
    };

    const PictureShard& shard() const { return sum_.state.shard; }

    void refuse(std::string text) { diagnostics_.add(error(Fault::option, {}, std::move(text))); }

    /// `least`: the smallest tolerance that allows the gap.
    void missing(const std::string& what, Gaps least) {
        if (gaps_ >= least)
            diagnostics_.add(warning(Fault::option, {}, what));
        else
            diagnostics_.add(error(Fault::option, {}, what)
                                 .with_help(gaps_ == Gaps::none
                                                ? "--partial makes a picture of what there is"
                                                : "a picture can have such a gap, a state cannot"));
    }

    void begin(const Checkpoint& first) {
        const Film& film = first.state.film;
        sum_.identity = first.identity;
        sum_.all_samples = first.all_samples;
        sum_.finished = true;
        sum_.state.shard = first.state.shard;
        sum_.state.film = Film(film.width(), film.height(), film.aovs());
    }

    void compare(const std::string& name, const Checkpoint& one) {
        const auto mixed = [&](const std::string& why) {
            refuse(message("`", printable(name), "` does not belong to `",
                           printable(parts_.front().name), "`: ", why));
        };
        std::string different = difference(sum_.identity, one.identity);
        if (different.empty()) different = difference(one.identity, sum_.identity);
        if (!different.empty()) return mixed(different);
        if (one.all_samples != sum_.all_samples)
            return mixed(message("it is of a picture with ", one.all_samples, " samples, not ",
                                 sum_.all_samples));
        const Film& film = one.state.film;
        const Film& other = sum_.state.film;
        const PictureShard& its = one.state.shard;
        if (film.width() != other.width() || film.height() != other.height() ||
            film.aovs() != other.aovs() || its.tile_step != shard().tile_step ||
            its.region != shard().region)
            mixed("the picture was cut in another way");
    }

    void sum_up(const Checkpoint& one) {
        Film& film = sum_.state.film;
        const Film& part = one.state.film;
        for (int y = 0; y < part.height(); ++y)
            for (int x = 0; x < part.width(); ++x)
                // A shard of tiles also has samples in the margins of its tiles.
                if (one.state.shard.owns(x, y)) {
                    film.add(film.index(x, y), part);
                    film.at(x, y).planned += part.at(x, y).planned;
                }
        sum_.samples += one.samples;
        sum_.finished &= one.finished;
    }

    /// Joins what the states have kept of the light of lamps, if all have.
    void join_lamps(const std::string& name, const Checkpoint& one) {
        if (parts_.size() > 1 && !lamps_) return;
        auto part = one.lamps.empty() ? nullptr : LightRecorder::of_state(one.lamps);
        if (!part || parts_.size() == 1)
            lamps_ = std::move(part);
        else if (!lamps_->adopt(std::move(*part), one.state.shard))
            refuse(message("`", printable(name), "` has kept light in another way than `",
                           printable(parts_.front().name), "`"));
    }

    void check_tiles() {
        const int count = shard().tile_step;
        std::set<int> found;
        for (const Part& part : parts_)
            if (const int number = part.shard.first_tile; !found.insert(number).second)
                refuse(message("shard ", number + 1, " of ", count, " is there twice: `",
                               printable(part.name), "`"));
        for (int i = 0; i < count; ++i)
            if (!found.count(i))
                missing(message("shard ", i + 1, " of ", count, " is missing"), Gaps::anywhere);
    }

    void check_samples() {
        std::uint32_t end = 0;
        const auto gap = [&](std::uint32_t from, std::uint32_t to, Gaps least) {
            if (from < to)
                missing(message("samples ", from, " to ", to - 1, " of 0 to ", sum_.all_samples - 1,
                                " are missing"),
                        least);
        };
        for (const Part& part : parts_) {
            const std::uint32_t begin = part.shard.first_sample;
            if (begin < end && part.samples > 0)
                refuse(message("`", printable(part.name), "` has samples from ", begin,
                               " on, of which another shard has some, too"));
            gap(end, begin, &part == &parts_.front() ? Gaps::around : Gaps::anywhere);
            end = std::max(end, begin + part.samples);
        }
        gap(end, sum_.all_samples, Gaps::around);
    }

    Gaps gaps_;
    Diagnostics& diagnostics_;
    std::vector<Part> parts_;
    Checkpoint sum_;
    std::unique_ptr<LightRecorder> lamps_;
};

struct Request {
    Options options;
    std::vector<std::string> files;
    bool partial = false;
    bool status = false;  ///< only says what is there
};

/// Whether an option, written as in an INI file, can change the result of merge.
bool matters(std::string_view given) {
    static constexpr auto all = std::to_array<std::string_view>(
        {"Output_File_Name=", "Output_File_Type=", "+F",
         "Bits_Per_Color=", "Grayscale_Output=", "Verbose=", "--diagnostics=", "--warn=",
         "Warning_Level=", "Input_File_Name=", "--sandbox=", "--keep-lights=", "Work_Threads="});
    return std::ranges::any_of(all, [&](std::string_view each) { return given.starts_with(each); });
}

Request read_request(std::span<const std::string_view> arguments, Diagnostics& diagnostics) {
    Request request;
    const auto take = [&](std::string_view name, const std::string&) {
        (name == "--partial" ? request.partial : request.status) = true;
    };
    const std::vector<std::string> words = take_options("merge", arguments, take, diagnostics);
    std::vector<std::string_view> others;
    for (const std::string& word : words)
        if (word.ends_with(state_ending) && !word.starts_with('+'))
            request.files.push_back(word);
        else
            others.push_back(word);
    request.options = read_options(others, diagnostics);
    for (const auto& [row, given] : request.options.given)
        if (!matters(given))
            diagnostics.add(
                warning(Fault::option, {},
                        message("`", printable(given),
                                "` is ignored: the states have the way in which the picture "
                                "is made")));
    if (request.options.scene)
        diagnostics.add(error(Fault::option, {},
                              message("`", printable(*request.options.scene),
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

/// Returns the default path of the picture: the name of the shards without their numbers.
std::string usual_output(std::string file) {
    file.resize(file.size() - state_ending.size());
    const std::size_t dot = file.rfind('.');
    const bool shard = dot != file.npos && file.find("of", dot) != file.npos;
    return shard ? file.substr(0, dot) : file;
}

bool makes_state(const Request& request) { return request.options.output.ends_with(state_ending); }

bool write_result(const Request& request, const Checkpoint& result, const LightRecorder* lamps,
                  Diagnostics& diagnostics) {
    Options options = request.options;
    if (!lamps && !options.kept_lights.empty()) {
        diagnostics.add(error(Fault::option, {}, "not all of the states have kept light of lamps")
                            .with_help("render all shards with --keep-lights FILE"));
        return false;
    }
    if (makes_state(request)) {
        const auto bytes = encode(result, diagnostics);
        return bytes && write_file(options.output, *bytes, diagnostics);
    }
    if (options.output.empty()) options.output = usual_output(request.files.front());
    FilmFiles files;
    tell_layers(result.identity, files);
    options.alpha = files.alpha;
    options.layers = files.layers;
    const std::size_t needed = files.aovs().count(files.lights.size());
    if (result.state.film.aovs() < needed)
        diagnostics.add(error(Fault::io, {},
                              message("the states have ", result.state.film.aovs(),
                                      " further sums of each pixel; their layers need ", needed)));
    Output output = output_of(options, diagnostics);
    if (diagnostics.failed()) return false;
    output.format.gamma = number(fact(result.identity, "gamma")).value_or(1);
    output.format.encoded = fact(result.identity, "encoded") == "yes";
    output.format.file_gamma = file_gamma_of(result.identity);
    output.format.description =
        description(result.identity, static_cast<int>(result.samples), output.format);
    files.path = output.path;
    files.format = output.format;
    files.threads = options.render.threads;
    if (!options.kept_lights.empty())
        write_kept_lights(*lamps, result.state.film, files, options.kept_lights, diagnostics);
    return write_film(result.state.film, files, diagnostics) && !diagnostics.failed();
}

}  // namespace

int merge(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    Request request = read_request(arguments, diagnostics);
    const auto end = [&](int status) {
        say_errors(console, request.options, diagnostics);
        return status;
    };
    if (!diagnostics.failed())
        confined(request.options, sandbox_rules(request.options, console.library, request.files),
                 console, diagnostics);
    if (diagnostics.failed()) return end(exit_status::usage);
    std::ranges::sort(request.files);  // the output does not depend on their order
    const Gaps gaps = !request.partial       ? Gaps::none
                      : makes_state(request) ? Gaps::around
                                             : Gaps::anywhere;
    Joiner joiner(gaps, diagnostics);
    for (const std::string& file : request.files) {
        auto state = read_checkpoint(file, diagnostics);
        if (!state) return end(exit_status::file);
        joiner.add(file, *state);
    }
    const auto result = joiner.finish();
    if (request.status) console.out(joiner.report());
    if (!result) return end(exit_status::usage);
    if (request.status) return end(exit_status::done);
    return end(write_result(request, *result, joiner.lamps(), diagnostics) ? exit_status::done
                                                                           : exit_status::file);
}

}  // namespace candelabra
