// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Splits a VRML97 file into tokens (ISO/IEC 14772-1, annex A).
 */
#ifndef lms3dVRMLLexer_h
#define lms3dVRMLLexer_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

struct lms3dVRMLToken
{
  enum Kinds
  {
    END,
    WORD,
    NUMBER,
    STRING,
    MARK ///< one of { } [ ]
  };

  Kinds Kind = END;
  /// The characters of the file; for a string, those between the quotes. A view into the text of
  /// the lexer.
  std::string_view Text;
  /// Counted from 1.
  std::size_t Line = 1;
  double Number = 0.0;
  /// Whether Number has neither fraction nor exponent and fits into Integer.
  bool IsInteger = false;
  std::int32_t Integer = 0;
  /// Whether the closing quote of a string is missing. Such a string ends with its line.
  bool IsOpen = false;

  bool Is(char mark) const { return this->Kind == MARK && this->Text.front() == mark; }
  bool Is(std::string_view word) const { return this->Kind == WORD && this->Text == word; }
};

/**
 * Accepts every line ending and every form of number. Accepts "nan", "inf" and their spellings on
 * Windows as numbers that are not finite. No input is an error: any character belongs to a token.
 *
 * The text must outlive the lexer and its tokens.
 */
class lms3dVRMLLexer
{
public:
  explicit lms3dVRMLLexer(std::string_view text);

  /// Returns the current token: the last one read.
  const lms3dVRMLToken& Get() const { return this->Token; }

  /// Reads the next token.
  void Advance();

  ///@{
  /// Append the current token and its successors to a list while they are integers, or finite
  /// numbers; at most `maximum` numbers. Advance past the appended tokens.
  void AppendNumbers(std::vector<std::int32_t>& integers, std::size_t maximum);
  void AppendNumbers(std::vector<double>& reals, std::size_t maximum);
  ///@}

  /// Reads the next token as the name of a node or of an event: everything up to whitespace or a
  /// mark. Many files have names with points and leading digits, which VRML97 does not allow.
  void AdvanceToName();

  /// Returns whether the mark follows the current token.
  bool IsFollowedBy(char mark);

  /// Ends the text here: the current token becomes END.
  void Stop();

  /// Returns the fraction of the text that is done, 0 to 1.
  double GetFractionDone() const;

  /// Returns the number of bytes that are done.
  std::size_t GetOffset() const { return static_cast<std::size_t>(this->Position - this->Begin); }

  /// Returns the number of bytes up to the next ] or }, or to the end of the text.
  std::size_t GetBytesToListEnd();

private:
  void SkipBlanks();
  void EndLine();
  bool BeginToken();
  void ReadString();
  const char* FindQuote(const char* p) const;
  bool ReadNumber();
  void ReadWord(bool (*ends)(char));

  const char* Begin;
  const char* Position;
  const char* End;
  const char* ListEnd;
  std::size_t Line = 1;
  bool IsQuoteMissing = false;
  lms3dVRMLToken Token;
};

/// Resolves the escapes of a string: \" becomes " and \\ becomes \.
std::string lms3dUnescape(std::string_view text);

#endif
