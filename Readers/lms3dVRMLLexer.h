// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts a VRML97 file into tokens (ISO/IEC 14772-1, annex A).
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
  /// As in the file; of a string, what is between the quotes.
  std::string_view Text;
  /// From 1.
  std::size_t Line = 1;
  double Number = 0.0;
  /// Whether the number has neither fraction nor exponent and fits into Integer.
  bool IsInteger = false;
  std::int32_t Integer = 0;
  /// Of a string: whether its closing quote is missing. It ends with its line then.
  bool IsOpen = false;

  bool Is(char mark) const { return this->Kind == MARK && this->Text.front() == mark; }
  bool Is(std::string_view word) const { return this->Kind == WORD && this->Text == word; }
};

/**
 * Lines may end in any way, numbers have any of VRML's forms; besides, "nan", "inf" and what
 * Windows prints for them are numbers that are not finite. The text has to outlive the lexer.
 */
class lms3dVRMLLexer
{
public:
  explicit lms3dVRMLLexer(std::string_view text);

  /// The token that was read last.
  const lms3dVRMLToken& Get() const { return this->Token; }

  void Advance();

  ///@{
  /// Appends the current token and those behind it, so many at most, as long as they are integers,
  /// or finite numbers.
  void AdvanceOver(std::vector<std::int32_t>& integers, std::size_t most);
  void AdvanceOver(std::vector<double>& reals, std::size_t most);
  ///@}

  /// The next token is the name of a node or of an event: anything up to a blank or a mark, since
  /// files have names with points and leading digits, which VRML97 does not allow.
  void AdvanceToName();

  /// Whether a mark comes after the current token.
  bool IsFollowedBy(char mark);

  /// From now on there are no more tokens.
  void Stop();

  /// The share of the text that is done, 0 to 1.
  double GetShareDone() const;

  /// How many bytes of the text are done.
  std::size_t GetDone() const { return static_cast<std::size_t>(this->Position - this->Begin); }

  /// How many bytes there are up to the next ] or }, or else to the end.
  std::size_t GetLeftOfList();

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

/// A string as its author meant it: \" and \\ stand for the second character.
std::string lms3dUnescape(std::string_view text);

#endif
