#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/parallel.h"
#include "core/base/result.h"

namespace kerf {

// Locale-independent parsing of numbers in mesh files.

// Parses a number. Accepts a leading '+' and all spellings of nan and inf, including 1.#IND; numbers too
// large for a double give infinity, numbers too small give zero. A word that consists of digits, signs,
// points and exponent letters but is no number ("3.1+e2") is a garbled number and gives NaN. Returns nullopt
// for any other word.
std::optional<double> parse_number(std::string_view word);

// Parses an integer, clamped to 64 bits. Returns nullopt for any other word.
std::optional<int64_t> parse_integer(std::string_view word);

// Returns true if the text starts like the rest of "1.#IND", "1.#INF", "1.#QNAN" or "1.#SNAN" from the '#'
// on: Microsoft's C library printed non-finite numbers in this form before 2015.
bool continues_microsoft_nan(std::string_view text);

// Reads the bytes of one mesh file and never reads past their end. Scanners are independent of the locale and
// of each other, so that files can be read concurrently. A line ends with LF, CRLF or a lone CR; every other
// control character counts as a blank. Errors name the file and the line or byte of the last item read.
class Scanner {
 public:
  struct Syntax {
    bool comments = false;       // '#' to the end of the line is a comment
    bool continuations = false;  // '\' at the end of a line joins it with the next one
  };

  // The bytes must outlive the scanner. A UTF-8 byte order mark is skipped. `progress` may be null.
  Scanner(std::string_view bytes, std::string_view file_name, Syntax syntax, const Progress* progress);

  // The offset of the next byte, and the number of bytes left. Precondition of seek: position <= size.
  size_t position() const { return position_; }
  size_t left() const { return bytes_.size() - position_; }
  void seek(size_t position) {
    assert(position <= bytes_.size());
    position_ = position;
  }
  // Returns the bytes between two positions. Precondition: begin <= end <= the number of bytes.
  std::string_view between(size_t begin, size_t end) const {
    assert(begin <= end && end <= bytes_.size());
    return bytes_.substr(begin, end - begin);
  }
  // Returns the line, counted from 1, in which the last word or bytes read start. Linear in the position.
  size_t line() const { return line_of(last_); }

  // Text. A word ends at a blank, at the end of the line or at a comment; at the end of the file it is empty.

  // Skips blanks. Returns true if the line or the file ends there.
  bool at_line_end();
  // Skips blanks, line ends and comments. Returns true if the file ends there.
  bool at_end();
  // Reads the next word in this line, empty if there is none.
  std::string_view word();
  // Reads the rest of the line, including comments, without surrounding blanks.
  std::string_view rest_of_line();
  // Reads the next word in this line, treating '#' as an ordinary character; empty if there is none.
  std::string_view name();
  // Advances to the start of the next line.
  void skip_line();
  // Reads the next word in this line as a number (see parse_number). Counts garbled numbers.
  std::optional<double> number();
  std::optional<int64_t> integer();

  // Bytes.

  // Consumes the next n bytes. Precondition: n <= left().
  const char* take(size_t n);

  // Reports progress. Returns true if the user cancelled. Cheap; call every few values.
  bool cancelled();

  size_t garbled_numbers() const { return garbled_numbers_; }
  // Precondition: garbled_numbers() > 0. "3 garbled numbers, the first in line 12, count as not finite."
  std::string garbled_numbers_warning() const;

  // "FILE, line 3: WHAT."
  Error line_error(const std::string& what) const;
  // "FILE, byte 84: WHAT."
  Error byte_error(const std::string& what) const;
  // "FILE: WHAT."
  Error file_error(const std::string& what) const;
  // "FILE, line 3: expected WHAT, found 'WORD'", for the last word; or that the line or the file ends.
  Error expected(const std::string& what) const;

  // Returns an error if the file contains a zero byte and therefore is not text in the given format.
  std::optional<Error> refuse_binary(std::string_view format) const;

 private:
  bool is_word_end(size_t at) const;
  bool skip_continuation();
  size_t line_of(size_t position) const;

  std::string_view bytes_;
  std::string file_name_;
  Syntax syntax_;
  const Progress* progress_;
  size_t position_ = 0;
  size_t last_ = 0;         // start of the last word or bytes read
  size_t next_report_ = 0;  // position of the next progress report
  size_t garbled_numbers_ = 0;
  size_t first_garbled_ = 0;
};

// Formats a word of a file for an error message: quoted, shortened, on one line.
std::string in_quotes(std::string_view word);

// Formats a name for an error message: on one line, at full length and without quotes.
std::string one_line(std::string_view name);

// Formats a list in a message: "UVs, normals or tangents".
std::string listed(std::span<const std::string> names, std::string_view last = " or ");

}  // namespace kerf
