#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// Walks over the bytes of one mesh file and never past them. Knows no locale and holds all its state, so that
// files can be read at the same time. A line ends with LF, CRLF or a lone CR; every other control character
// is a blank. An error names the file and the line or the byte of what was read last.
class Scanner {
 public:
  struct Syntax {
    bool comments = false;       // '#' to the end of the line is a comment
    bool continuations = false;  // '\' before the end of a line joins the next one
  };

  // The bytes must outlive the scanner. A byte order mark of UTF-8 is skipped.
  Scanner(std::string_view bytes, std::string_view file_name, Syntax syntax, const Progress* progress);

  size_t position() const { return position_; }
  size_t left() const { return bytes_.size() - position_; }
  // The bytes from one position to another; begin <= end <= the length of the file.
  std::string_view between(size_t begin, size_t end) const { return bytes_.substr(begin, end - begin); }
  // The number, from 1, of the line in which the last word or bytes begin. Linear in the bytes before it.
  size_t line() const { return line_of(last_); }
  void seek(size_t position) { position_ = position; }

  // Text. The words end at blanks, line ends and comments; at the end of the file they are empty.

  // Skips blanks; whether the line (or the file) ends there.
  bool at_line_end();
  // Skips blanks, line ends and comments; whether the file ends there.
  bool at_end();
  // The next word in this line, empty when there is none.
  std::string_view word();
  // The rest of the line without blanks around it, comments included.
  std::string_view rest_of_line();
  // To the start of the next line.
  void skip_line();
  // The next word in this line as a number (see number.h); a garbled one is counted.
  std::optional<double> number();
  std::optional<int64_t> integer();

  // Bytes.

  // The next n bytes, which must be there.
  const char* take(size_t n);

  // Whether the user wants the reading to stop; to be asked every few values, and cheap.
  bool cancelled();

  size_t garbled_numbers() const { return garbled_numbers_; }
  // "3 garbled numbers, the first in line 12, count as not finite."
  std::string garbled_numbers_warning() const;

  // "FILE, line 3: WHAT."
  Error line_error(const std::string& what) const;
  // "FILE, byte 84: WHAT."
  Error byte_error(const std::string& what) const;
  // "FILE: WHAT."
  Error file_error(const std::string& what) const;
  // "FILE, line 3: expected WHAT, found 'WORD'", or that the line or the file ends there.
  Error expected(const std::string& what) const;

  // Text is free of zero bytes; where there is one, why this file is no text in such a format.
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
  size_t last_ = 0;         // where the word or the bytes read last begin
  size_t next_report_ = 0;  // the position at which progress is due
  size_t garbled_numbers_ = 0;
  size_t first_garbled_ = 0;
};

// A word of a file as an error message shows it: in quotes, short, in one line.
std::string quoted(std::string_view word);

// The same for a name, without quotes and at full length.
std::string one_line(std::string_view name);

}  // namespace kerf
