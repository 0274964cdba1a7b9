// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/element.h"
#include "text/ascii.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace candelabra::proof {

namespace {

/// Marks as written() knows them in the place of those in comments.
std::string with_marks(std::string text) {
    static const std::regex amount(R"(([-+0-9.e]+)/\*light (-?[0-9]+)\*/)");
    static const std::regex word(R"((no_luminaire|luminaire)?/\*(no_luminaire|luminaire)\*/)");
    static const std::regex comment("//[^\n]*|#version [0-9.]+;");
    text = std::regex_replace(text, amount, "@$1#$2@");
    text = std::regex_replace(text, word, "$$$2$$");
    return std::regex_replace(text, comment, "");
}

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '#';
}

std::string trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return std::string(text);
}

class Splitter {
public:
    explicit Splitter(std::string_view text) : text_(text) {}

    /// What stands up to a closing brace, or to the end.
    std::vector<Element> elements() {
        std::vector<Element> result;
        std::size_t begin = at_;
        const auto add_words = [&](std::size_t end) {
            if (std::string loose = trimmed(text_.substr(begin, end - begin)); !loose.empty())
                result.push_back(words(std::move(loose)));
        };
        for (; at_ < text_.size() && text_[at_] != '}'; at_ = std::min(at_ + 1, text_.size())) {
            if (text_[at_] == '"') at_ = std::min(text_.find('"', at_ + 1), text_.size() - 1);
            if (text_[at_] != '{') continue;
            const std::size_t word = word_before(at_);
            add_words(word);
            std::string head = trimmed(text_.substr(word, at_ - word));
            ++at_;
            result.push_back(block_of(std::move(head)));
            begin = std::min(at_ + 1, text_.size());
        }
        add_words(at_);
        return result;
    }

private:
    std::size_t word_before(std::size_t brace) const {
        std::size_t end = brace;
        while (end > 0 && is_blank(text_[end - 1])) --end;
        std::size_t word = end;
        while (word > 0 && is_of_word(text_[word - 1])) --word;
        return word;
    }

    Element block_of(std::string head) {
        Element element = block(std::move(head), "", elements());
        if (!element.inner.empty() && element.inner.front().head.empty()) {
            element.values = element.inner.front().values;
            element.inner.erase(element.inner.begin());
        }
        return element;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

int lights_of(const std::string& text) {
    static const std::regex mark("#([0-9]+)@");
    int count = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), mark), end; i != end; ++i)
        count = std::max(count, std::stoi((*i)[1]) + 1);
    return count;
}

}  // namespace

std::string trouble_with_braces(std::string_view text) {
    const std::string marked = with_marks(std::string(text));
    std::vector<int> open;
    int line = 1;
    bool quoted = false;
    for (const char c : marked) {
        if (c == '"') quoted = !quoted;
        if (c == '\n') ++line;
        if (quoted) continue;
        if (c == '{') open.push_back(line);
        if (c != '}') continue;
        if (open.empty()) return "the `}` in line " + std::to_string(line) + " has no `{`";
        open.pop_back();
    }
    if (quoted) return "a string has no end";
    return open.empty() ? "" : "the `{` in line " + std::to_string(open.back()) + " has no `}`";
}

Script script_of(std::string_view text) {
    const std::string marked = with_marks(std::string(text));
    Script script;
    script.elements = Splitter(marked).elements();
    script.lights = lights_of(marked);
    return script;
}

}  // namespace candelabra::proof
