// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/json_reader.h"

#include "interpret/array_data.h"
#include "text/message.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace candelabra {

namespace {

using NamesHandle = std::shared_ptr<const IndexNames>;

/// Handler of the events of nlohmann's parser; returning false stops it.
class JsonBuilder {
public:
    JsonBuilder(std::size_t most, JsonProblem& problem) : most_(most), problem_(problem) {}

    Value take() { return std::move(result_); }

    bool null() { return add(Absence::uninitialised); }
    bool boolean(bool value) { return add(value ? 1.0 : 0.0); }
    bool number_integer(std::int64_t value) { return add(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return add(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool key(std::string& name) {
        open_.back().keys.push_back(std::move(name));
        return true;
    }
    bool start_object(std::size_t) { return start(true); }
    bool start_array(std::size_t) { return start(false); }
    bool end_object() { return end(); }
    bool end_array() { return end(); }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) {
        // The position counts the characters read, including the wrong one or the last.
        problem_ = {position > 0 ? position - 1 : 0, true, "is no JSON from here on"};
        return false;
    }

private:
    /// A list or an object that has not ended.
    struct Level {
        bool object = false;
        std::vector<std::string> keys;
        std::vector<double> numbers;  ///< the values, as long as all are numbers
        std::vector<Value> values;    ///< otherwise
    };

    bool fail(std::string why) {
        problem_ = {0, false, std::move(why)};
        return false;
    }

    bool add(Value value) {
        if (++count_ > most_)
            return fail(message("has more than ", most_, " values, which is the limit"));
        put(std::move(value));
        return true;
    }

    void put(Value value) {
        if (open_.empty()) {
            result_ = std::move(value);
            return;
        }
        Level& level = open_.back();
        const Numbers* number = value.numbers();
        if (number && level.values.empty()) return level.numbers.push_back(number->at[0]);
        if (!level.numbers.empty()) {
            level.values.assign(level.numbers.begin(), level.numbers.end());
            level.numbers = {};
        }
        level.values.push_back(std::move(value));
    }

    bool start(bool object) {
        if (open_.size() == max_json_depth)
            return fail(message("has more than ", max_json_depth,
                                " lists and objects inside each other, which is the limit"));
        open_.push_back({object, {}, {}, {}});
        return true;
    }

    bool end() {
        Level level = std::move(open_.back());
        open_.pop_back();
        return add(made(std::move(level)));
    }

    Value made(Level level) {
        const NamesHandle names = level.object ? shared(std::move(level.keys)) : nullptr;
        if (!level.numbers.empty()) {
            const auto size = static_cast<int>(level.numbers.size());
            return array(ArrayData({size}, std::move(level.numbers)), names);
        }
        if (level.values.empty()) return Absence::uninitialised;
        if (!level.object && alike(level.values)) return joined(level.values);
        ArrayData result({static_cast<int>(level.values.size())});
        for (std::size_t i = 0; i < level.values.size(); ++i)
            if (!level.values[i].absent()) result.set(i, std::move(level.values[i]));
        return array(std::move(result), names);
    }

    static Value array(ArrayData data, NamesHandle names) {
        data.set_names(std::move(names));
        return make_handle<ArrayData>(std::move(data));
    }

    /// Objects of a list mostly have the same names, so they share them.
    NamesHandle shared(std::vector<std::string> keys) {
        NamesHandle& known = names_[keys];
        if (!known) known = std::make_shared<const IndexNames>(std::move(keys));
        return known;
    }

    /// Whether all are arrays of the same sizes and names, with room for one more dimension.
    static bool alike(const std::vector<Value>& values) {
        constexpr std::size_t max_dimensions = 5;
        const ArrayData* const first = values.front().array();
        return first && first->sizes().size() < max_dimensions &&
               std::ranges::all_of(values, [&](const Value& value) {
                   const ArrayData* const each = value.array();
                   return each && each->sizes() == first->sizes() &&
                          each->names() == first->names();
               });
    }

    static Value joined(const std::vector<Value>& values) {
        const ArrayData& first = *values.front().array();
        std::vector<int> sizes = {static_cast<int>(values.size())};
        sizes.insert(sizes.end(), first.sizes().begin(), first.sizes().end());
        ArrayData result(std::move(sizes));
        std::size_t at = 0;
        for (const Value& value : values)
            for (std::size_t i = 0; i < first.size(); ++i, ++at)
                if (value.array()->has(i)) result.set(at, value.array()->at(i));
        return array(std::move(result), first.names());
    }

    std::size_t most_, count_ = 0;
    JsonProblem& problem_;
    std::vector<Level> open_;
    std::map<std::vector<std::string>, NamesHandle> names_;
    Value result_ = Absence::uninitialised;
};

}  // namespace

std::optional<Value> read_json(std::string_view text, std::size_t most, JsonProblem& problem) {
    JsonBuilder builder(most, problem);
    using Json = nlohmann::json;
    const bool strict = true, without_comments = true;
    if (!Json::sax_parse(text.begin(), text.end(), &builder, Json::input_format_t::json, strict,
                         without_comments)) {
        problem.at = std::min(problem.at, text.size());
        return std::nullopt;
    }
    return builder.take();
}

}  // namespace candelabra
