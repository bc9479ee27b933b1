// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes a document of a file's text, whatever the text is.
 */
#ifndef lms3dVRMLParser_h
#define lms3dVRMLParser_h

#include "lms3dVRMLLexer.h"
#include "lms3dVRMLNode.h"

#include <cstddef>
#include <string>
#include <string_view>

class lms3dVRMLContext;
class lms3dVRMLScope;

/**
 * By recursive descent. What it cannot understand becomes a message, and it goes on behind.
 *
 * Statements are in lms3dVRMLParser.cxx; nodes, their fields, the values of fields and prototypes in
 * lms3dVRMLNodeParser.cxx, lms3dVRMLFieldParser.cxx, lms3dVRMLValueParser.cxx and
 * lms3dVRMLPrototypeParser.cxx.
 */
class lms3dVRMLParser
{
public:
  lms3dVRMLParser(std::string_view text, lms3dVRMLDocument& document, lms3dVRMLContext& context);

  void Parse();

private:
  // Each begins at the current token and leaves off behind what it is named after, or where that can
  // no longer go on. Those named Is... only look.

  ///@{
  /// Up to the } of what is around them, or the end. A node that cannot be read keeps its place, null.
  void ParseStatements(lms3dVRMLNodes& nodes);
  /// PROTO, EXTERNPROTO or ROUTE; false, and nothing is done, where none is here.
  bool ParseDeclaringStatement();
  void ParseRoute();
  ///@}

  ///@{
  /// From PROTO or EXTERNPROTO on.
  void ParsePrototype(bool isExternal);
  void PassOverPrototype(const lms3dVRMLPrototype& prototype);
  void ParseInterface(lms3dVRMLPrototype& prototype);
  void ParseUrls(lms3dVRMLPrototype& prototype);
  void ParsePrototypeBody(lms3dVRMLPrototype& prototype);
  /// Fields have values but in the interface of an EXTERNPROTO; events never have.
  void ParseDeclaration(std::vector<lms3dVRMLField>& fields, bool hasValues);
  bool IsAtDeclaration() const;
  ///@}

  ///@{
  /// Null, and a message, where there is no node that can be read; null alone for NULL.
  const lms3dVRMLNode* ParseNodeStatement();
  const lms3dVRMLNode* ParseUse();
  /// From DEF up to the type's name; false where there is none.
  bool ParseDefinition(std::string_view& name);
  /// From the type's name on, which { follows.
  const lms3dVRMLNode* ParseNode(std::string_view name);
  lms3dVRMLNode* BeginNode(std::string_view name);
  void ParseNodeBody(lms3dVRMLNode& node);
  void ParseBodyElement(lms3dVRMLNode& node);
  void ParseField(lms3dVRMLNode& node);
  void EndField(lms3dVRMLNode& node, lms3dVRMLField&& field, bool hasSurfaces);
  void AddField(lms3dVRMLNode& node, lms3dVRMLField&& field);
  void PassOverField(const lms3dVRMLNode& node, const lms3dVRMLField& field, bool hasSurfaces);
  /// A node that stands where a field should.
  void TakeForChild(lms3dVRMLNode& node);
  bool IsNodeType(std::string_view name) const;
  bool IsAtNode();
  ///@}

  ///@{
  /// The tokens alone say what a value is; monostate, and a message, where there is none. A list
  /// continues the value that it is given.
  lms3dVRMLValue ParseValue();
  lms3dVRMLValue ParseWordValue();
  void ParseList(lms3dVRMLValue& value);
  void ParseListElement(lms3dVRMLValue& value);
  void ParseNumbers(lms3dVRMLValue& value);
  template <typename List>
  void ParseRun(List& numbers);
  void ParseWordAmongNumbers(lms3dVRMLValue& value);
  void ParseStrings(lms3dVRMLValue& value);
  void ParseNodes(lms3dVRMLValue& value);
  ///@}

  const lms3dVRMLToken& Get() const { return this->Lexer.Get(); }
  void Advance() { this->Lexer.Advance(); }
  /// Whether the file ends here, which is told once.
  bool IsAtEnd(std::string_view inside);
  /// Goes on behind a mark; false where another token is.
  bool Enter(char mark, std::string_view what);
  /// One token that has no meaning here.
  void PassOver();
  /// From an opening mark to behind the one that closes it; nothing where another token is.
  void PassOverBlock(char opening, char closing);
  /// Tells the progress, and stops where the user wants no more.
  void Tick();
  void Stop();
  /// The same name in the document, which outlives the text.
  std::string_view Keep(std::string_view name);
  static std::string Quote(std::string_view text);

  ///@{
  /// A message about the current line: a warning; an error; an error where surfaces may depend on
  /// what is parsed, else a warning.
  void Warn(const std::string& text);
  void Lose(const std::string& text);
  void LoseHere(const std::string& text);
  ///@}

  lms3dVRMLLexer Lexer;
  lms3dVRMLDocument& Document;
  lms3dVRMLContext& Context;
  lms3dVRMLScope* Scope = nullptr;
  /// How many nodes and prototypes are around the current token.
  int Depth = 0;
  /// Whether surfaces may depend on what is parsed: not within an Appearance, for example.
  bool MayBeSeen = true;
  double ShareReported = 0.0;
  /// How many nodes that may show surfaces were met.
  std::size_t Surfaces = 0;
  bool HasToldEnd = false;
};

#endif
