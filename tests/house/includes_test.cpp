// SPDX-License-Identifier: GPL-3.0-or-later
// Each source includes the headers of what it uses, or has them by other headers of the program.
// Standard headers that it has only by other standard headers are missing with another library, or
// its next version; those of the program that it has only by the source compiled before it, where
// sources are compiled one by one. With a compiler headers.py checks the latter in headers, and
// alone.sh, which takes longer, in sources as well.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

const fs::path source = fs::path(CANDELABRA_SOURCE_DIR) / "src";

/// Headers, each with names that it declares. Names that several headers declare are left out.
constexpr const char* declared = R"(
algorithm: sort stable_sort max clamp find find_if find_if_not any_of all_of none_of copy copy_n
    copy_if fill fill_n transform lower_bound upper_bound equal_range binary_search unique remove_if
    reverse rotate stable_partition nth_element minmax min_element max_element minmax_element count
    count_if equal mismatch search for_each generate replace is_sorted adjacent_find includes merge
    set_intersection set_union set_difference inplace_merge partition_point reverse_copy
array: array to_array
atomic: atomic atomic_flag atomic_ref memory_order_relaxed memory_order_acquire
bit: bit_cast bit_width countr_zero countl_zero popcount has_single_bit bit_ceil bit_floor rotl rotr
charconv: from_chars to_chars from_chars_result to_chars_result chars_format
cmath: sqrt floor ceil round trunc fmod fma ldexp frexp remainder isfinite isnan isinf signbit
    copysign fmin fmax lround llround nearbyint rint nextafter modf ilogb isnormal
compare: strong_ordering weak_ordering partial_ordering
concepts: same_as convertible_to integral floating_point derived_from invocable constructible_from
condition_variable: condition_variable
csetjmp: jmp_buf longjmp
cstddef: size_t ptrdiff_t byte nullptr_t max_align_t
cstdint: int8_t uint8_t int16_t uint16_t int32_t uint32_t int64_t uint64_t uintptr_t intptr_t
cstdio: FILE fopen fclose fread fwrite printf fprintf snprintf fputs fflush
cstdlib: getenv exit abort strtod malloc free aligned_alloc _Exit
cstring: memcpy memcmp memset memmove strlen strcmp strerror strchr
deque: deque
exception: exception exception_ptr current_exception rethrow_exception
fstream: ifstream ofstream
functional: function invoke less greater plus multiplies reference_wrapper ref cref identity not_fn
future: future promise async future_status launch
initializer_list: initializer_list
iterator: back_inserter distance next prev advance istreambuf_iterator inserter make_move_iterator
    iterator_traits iter_swap
limits: numeric_limits
list: list
map: map multimap
memory: unique_ptr shared_ptr weak_ptr make_unique make_shared construct_at destroy_at
mutex: mutex lock_guard unique_lock scoped_lock call_once once_flag recursive_mutex
new: bad_alloc nothrow launder align_val_t
numeric: accumulate iota inner_product partial_sum gcd lcm midpoint
optional: optional nullopt nullopt_t make_optional
random: mt19937 mt19937_64
set: set multiset
shared_mutex: shared_mutex shared_lock
span: span
sstream: ostringstream istringstream stringstream
stdexcept: runtime_error logic_error out_of_range invalid_argument
string: string to_string stoi stod getline
string_view: string_view
system_error: errc error_code system_error generic_category
thread: thread jthread
tuple: tuple tie apply make_tuple
type_traits: is_same_v decay_t remove_cvref_t conditional_t enable_if_t is_integral_v is_enum_v
    is_floating_point_v is_base_of_v underlying_type_t invoke_result_t is_arithmetic_v is_void_v
    is_unsigned_v make_unsigned_t remove_reference_t is_constructible_v is_convertible_v
unordered_map: unordered_map
unordered_set: unordered_set
utility: pair move forward swap exchange make_pair as_const index_sequence make_index_sequence
    declval piecewise_construct
variant: variant visit get_if holds_alternative monostate
vector: vector
)";

/// The header of each name.
std::map<std::string, std::string> headers_of_names() {
    std::map<std::string, std::string> headers;
    std::istringstream words(declared);
    std::string header;
    for (std::string word; words >> word;) {
        if (word.back() == ':')
            header = word.substr(0, word.size() - 1);
        else
            headers[word] = header;
    }
    return headers;
}

/// Words, numbers and signs of a source, and what it includes.
struct Source {
    std::set<std::string> standard;  ///< headers that it includes
    std::vector<std::string> own;    ///< of the program
    std::vector<std::string> tokens;
    std::set<std::string> names;    ///< which it declares, at any place
    std::set<std::string> exports;  ///< types and functions at the left margin
};

bool is_word(const std::string& token) {
    return std::isalpha(static_cast<unsigned char>(token[0])) || token[0] == '_';
}

void add_tokens(const std::string& line, std::vector<std::string>& tokens) {
    static const std::regex token(R"re("(?:\\.|[^"\\])*"|\w+|::|->|[^\s\w])re");
    for (std::sregex_iterator i(line.begin(), line.end(), token), end; i != end; ++i)
        tokens.push_back(i->str());
}

/// Whether a word after this one may be a name that is declared.
bool comes_before_a_name(const std::string& token) {
    static const std::set<std::string> other = {"return", "new", "throw", "else", "case", "delete"};
    static const std::set<std::string> signs = {">", "*", "&", "]"};
    return is_word(token) ? !other.contains(token) : signs.contains(token);
}

std::set<std::string> declared_names(const std::vector<std::string>& tokens) {
    static const std::set<std::string> kinds = {"class", "struct",   "enum",   "union",
                                                "using", "typename", "concept"};
    static const std::set<std::string> after = {"(", "{", ";", ",", ")", "=", "["};
    std::set<std::string> names;
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i)
        if (is_word(tokens[i]) &&
            (kinds.contains(tokens[i - 1]) ||
             (comes_before_a_name(tokens[i - 1]) && after.contains(tokens[i + 1]))))
            names.insert(tokens[i]);
    return names;
}

/// The type or function that a line at the left margin declares; empty if there is none.
std::string exported(const std::string& line) {
    static const std::regex type(
        R"(^(?:class|struct|enum class|enum|union) (?:\[\[.*\]\] |alignas\(\w+\) )?(\w+)(?![^{]*;))");
    static const std::regex alias(R"(^(?:using|concept) (\w+) =)");
    static const std::regex function(
        R"(^(?!using|return|template|namespace|class|struct|enum)[\w:][\w:<>,&* \[\]]* [&*]?(\w+)\()");
    std::smatch match;
    if (line.empty() || line[0] == ' ' || line[0] == '#' || line[0] == '}') return {};
    for (const std::regex* form : {&type, &alias, &function})
        if (std::regex_search(line, match, *form)) return match[1];
    return {};
}

Source read_source(const fs::path& path) {
    Source read;
    std::ifstream file(path, std::ios::binary);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("#include <"))
            read.standard.insert(line.substr(10, line.find('>') - 10));
        else if (line.starts_with("#include \""))
            read.own.push_back(line.substr(10, line.rfind('"') - 10));
        if (line.starts_with("#")) continue;
        if (const std::size_t comment = line.find("//"); comment != line.npos) line.resize(comment);
        if (const std::string name = exported(line); !name.empty()) read.exports.insert(name);
        add_tokens(line, read.tokens);
    }
    read.names = declared_names(read.tokens);
    return read;
}

class Sources {
public:
    const Source& at(const fs::path& path) {
        const auto known = known_.find(path.string());
        if (known != known_.end()) return known->second;
        return known_.emplace(path.string(), read_source(path)).first->second;
    }
    /// The file, and the headers of the program that it has.
    std::vector<fs::path> reached(const fs::path& path) {
        std::set<std::string> seen = {path.string()};
        std::vector<fs::path> found = {path};
        for (std::size_t i = 0; i < found.size(); ++i)
            for (const std::string& own : std::vector<std::string>(at(found[i]).own))
                if (fs::exists(source / own) && seen.insert((source / own).string()).second)
                    found.push_back(source / own);
        return found;
    }

private:
    std::map<std::string, Source> known_;
};

std::vector<fs::path> all_sources() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(source))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
            files.push_back(entry.path());
    return files;
}

/// Types, and functions that are called, by their names alone.
std::set<std::string> used_names(const std::vector<std::string>& tokens) {
    static const std::set<std::string> inside = {".", "->", "::"};
    std::set<std::string> called, otherwise;
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
        if (!is_word(tokens[i]) || inside.contains(tokens[i - 1])) continue;
        const bool type = std::isupper(static_cast<unsigned char>(tokens[i][0])) != 0;
        (type || tokens[i + 1] == "(" ? called : otherwise).insert(tokens[i]);
    }
    for (const std::string& name : otherwise) called.erase(name);  // variables
    return called;
}

}  // namespace

TEST_CASE("each source includes the standard headers of what it uses", "[house]") {
    const std::map<std::string, std::string> headers = headers_of_names();
    REQUIRE(headers.at("uint8_t") == "cstdint");
    Sources sources;
    for (const fs::path& path : all_sources()) {
        std::set<std::string> standard, missing;
        for (const fs::path& file : sources.reached(path))
            standard.insert(sources.at(file).standard.begin(), sources.at(file).standard.end());
        const std::vector<std::string>& tokens = sources.at(path).tokens;
        for (std::size_t i = 0; i + 4 < tokens.size(); ++i) {
            if (tokens[i] != "std" || tokens[i + 1] != "::") continue;
            const auto header = headers.find(tokens[i + (tokens[i + 2] == "ranges" ? 4 : 2)]);
            if (header != headers.end() && !standard.contains(header->second))
                missing.insert(header->second);
        }
        for (const std::string& header : missing)
            FAIL_CHECK(path.string() << " does not include <" << header << ">");
    }
}

TEST_CASE("each source has the headers of the program that it uses by itself", "[house]") {
    Sources sources;
    std::map<std::string, std::set<std::string>> headers;
    for (const fs::path& path : all_sources())
        if (path.extension() == ".h")
            for (const std::string& name : sources.at(path).exports)
                headers[name].insert(path.string());
    REQUIRE(headers.contains("Ray"));
    for (const fs::path& path : all_sources()) {
        std::set<std::string> names, had;
        for (const fs::path& file : sources.reached(path)) {
            had.insert(file.string());
            names.insert(sources.at(file).names.begin(), sources.at(file).names.end());
        }
        for (const std::string& name : used_names(sources.at(path).tokens)) {
            const auto known = headers.find(name);
            if (known == headers.end() || names.contains(name)) continue;
            const bool found = std::any_of(known->second.begin(), known->second.end(),
                                           [&](const std::string& h) { return had.contains(h); });
            if (!found)
                FAIL_CHECK(path.string()
                           << " does not have " << *known->second.begin() << ", for " << name);
        }
    }
}

}  // namespace candelabra
