// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/films.h"

#include "reading/item_block.h"
#include "reading/item_reader.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <cmath>

namespace candelabra {

namespace {

/// While it exists, `auto` is a vector of 0 and 1, to which expressions such as `auto + 0.5` add,
/// unless the scene has declared this name.
class AutoName {
public:
    explicit AutoName(Evaluator& evaluator)
        : evaluator_(evaluator), name_(evaluator.names().intern("auto")) {
        if (evaluator.find(name_)) return;
        declared_ = true;
        evaluator.declare("auto", Numbers{{0, 1}, 2});
    }
    AutoName(const AutoName&) = delete;
    AutoName& operator=(const AutoName&) = delete;
    ~AutoName() {
        if (declared_) evaluator_.undeclare(name_);
    }

private:
    Evaluator& evaluator_;
    NameId name_;
    bool declared_ = false;
};

/// Reads the fields, some of which take a word as their value: `response agx`, `pixel_filter box`,
/// `exposure auto`.
class FilmFields {
public:
    FilmFields(OpenBlock& block, FilmSettings& film)
        : block_(block), film_(film), fields_(block, FilmSettings::vocabulary, &film) {}

    bool waiting() const { return fields_.waiting(); }
    bool wants() const { return fields_.wants(); }
    bool take(const Element& element) {
        const std::string_view expected = fields_.expected();
        const Numbers* numbers = element.value.numbers();
        if (expected == "exposure" && numbers && numbers->count == 2)
            return take_automatic(element, *numbers);
        if (element.kind != Element::Kind::word) return fields_.take(element);
        if (expected == "response")
            return take_name(element, response_names(), "response of a film");
        if (expected == "pixel_filter") return take_name(element, filter_names(), "pixel filter");
        return fields_.take(element);
    }
    void finish() { fields_.finish(); }
    void add_words(WordList& words) const { fields_.add_words(words); }

private:
    static Element with_value(Element element, Value value) {
        element.kind = Element::Kind::value;
        element.word = no_name;
        element.value = std::move(value);
        return element;
    }

    /// A number is added to both numbers of AutoName: their difference stays.
    bool take_automatic(const Element& element, const Numbers& numbers) {
        const double stops = numbers.at[0], apart = numbers.at[1] - stops;
        if (std::abs(apart - 1) > 1e-9) return fields_.take(element);
        film_.auto_exposure = true;
        return fields_.take(with_value(element, Numbers::scalar(stops)));
    }

    bool take_name(const Element& element, std::span<const std::string_view> names,
                   std::string_view noun) {
        const std::string word(block_.spelling(element.word));
        if (std::ranges::find(names, word) == names.end()) {
            std::string list;
            for (const std::string_view name : names)
                list += message(list.empty() ? "there are " : ", ", name);
            const std::string meant =
                nearest(word, std::vector<std::string_view>(names.begin(), names.end()));
            block_.report(error(Fault::unknown_name, element.span,
                                message("there is no ", noun, " `", printable(word), '`'))
                              .with_help(meant.empty()
                                             ? list
                                             : message("did you mean `", meant, "`? ", list)));
            return fields_.take(with_value(element, Absence::broken));
        }
        return fields_.take(with_value(element, word));
    }

    OpenBlock& block_;
    FilmSettings& film_;
    ItemReader fields_;
};

}  // namespace

bool FilmReader::take(const Element& element) {
    if (element.kind != Element::Kind::block ||
        camera_.spelling(element.word) != FilmSettings::vocabulary.name)
        return false;
    OpenBlock block(camera_.binder, FilmSettings::vocabulary.name, element.word_span);
    block.item = &FilmSettings::vocabulary;
    film_.on = true;
    FilmFields fields(block, film_);
    ItemBlock glare(block, Glare::vocabulary, &film_.glare, &film_.glares);
    {
        const AutoName automatic(camera_.binder.evaluator);
        block.read(element.body, glare, fields);
    }
    if (!block.broken)
        if (const std::string wrong = problem(film_); !wrong.empty())
            block.report(
                error(Fault::degenerate, element.word_span, wrong).with_help(block.help()));
    camera_.broken |= block.broken;
    return true;
}

}  // namespace candelabra
