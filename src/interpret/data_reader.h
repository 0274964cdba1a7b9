// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the values of a data file for #read: numbers with a sign, strings, and vectors of them,
// between commas or blanks, with the comments of the language. The text is kept with the sources,
// so that messages can point into it.
#pragma once

#include "interpret/value.h"
#include "syntax/lexer.h"

#include <optional>

namespace candelabra {

class DataReader {
public:
    DataReader(SourceId, const SourceStore&, Names&, Diagnostics&);

    /// Reads the next value and the comma after it. Returns nothing at the end of the file, and a
    /// broken value after a report.
    std::optional<Value> next();

    /// The place of the last value.
    Span place() const { return place_; }
    /// Whether a line ends between the last value and the one before it.
    bool behind_line_end() const { return behind_line_end_; }

    /// Whether the file has been read to its end. A comma after the last value announces another
    /// one, as in POV-Ray.
    bool at_end() const { return ahead_.kind == TokenKind::end_of_file && !after_comma_; }

private:
    Value value();
    Value vector();
    /// A number with its sign; nothing if there is none.
    std::optional<double> number();
    Value not_a_value();
    void advance();

    SourceId source_;
    const SourceStore& sources_;
    Diagnostics& diagnostics_;
    Tree tree_;  ///< holds the numbers and strings of the tokens
    Lexer lexer_;
    Token ahead_;
    bool after_comma_ = true;  ///< or at the start of the file
    Span place_;
    std::uint32_t taken_ = 0;  ///< end of the last token taken
    bool behind_line_end_ = false;
};

}  // namespace candelabra
