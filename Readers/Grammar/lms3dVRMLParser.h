// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parses the text of a VRML97 file into a document.
 */
#ifndef lms3dVRMLParser_h
#define lms3dVRMLParser_h

#include "Grammar/lms3dVRMLLexer.h"
#include "Grammar/lms3dVRMLNode.h"

#include <cstddef>
#include <string>
#include <string_view>

class lms3dVRMLContext;
class lms3dVRMLScope;

/**
 * A recursive descent parser that accepts any text: at a syntax error it adds a message and
 * continues behind the error. The text, the document and the context must outlive the parser.
 *
 * The implementation is in five files: statements are in lms3dVRMLParser.cxx, nodes in
 * lms3dVRMLNodeParser.cxx, fields in lms3dVRMLFieldParser.cxx, values in lms3dVRMLValueParser.cxx
 * and prototypes in lms3dVRMLPrototypeParser.cxx.
 */
class lms3dVRMLParser
{
public:
  lms3dVRMLParser(std::string_view text, lms3dVRMLDocument& document, lms3dVRMLContext& context);

  /// Parses the whole text. If the context is aborted or a limit is exceeded, stops early.
  void Parse();

private:
  // Each Parse function begins at the current token. It ends behind the construct of its name, or
  // at the token where the construct cannot continue. Functions named Is... do not advance.

  ///@{
  /// Parses up to the closing } of the enclosing construct, or the end. Appends null for a node
  /// that cannot be parsed.
  void ParseStatements(lms3dVRMLNodes& nodes);
  /// Parses PROTO, EXTERNPROTO or ROUTE. Returns false, and does nothing, at any other token.
  bool ParseDeclaringStatement();
  void ParseRoute();
  ///@}

  ///@{
  /// Begins at PROTO or EXTERNPROTO.
  void ParsePrototype(bool isExternal);
  void SkipPrototype(const lms3dVRMLPrototype& prototype);
  void ParseInterface(lms3dVRMLPrototype& prototype);
  void ParseUrls(lms3dVRMLPrototype& prototype);
  void ParsePrototypeBody(lms3dVRMLPrototype& prototype);
  /// `hasValues` is false in the interface of an EXTERNPROTO, whose fields have no values. Events
  /// never have values.
  void ParseDeclaration(std::vector<lms3dVRMLField>& fields, bool hasValues);
  bool IsAtDeclaration() const;
  ///@}

  ///@{
  /// Returns null for NULL. Returns null and adds a message if no node can be parsed here.
  const lms3dVRMLNode* ParseNodeStatement();
  const lms3dVRMLNode* ParseUse();
  /// Parses from DEF up to the name of the type. Returns false if there is no type.
  bool ParseDefinition(std::string_view& name);
  /// Begins at the name of the type, which { must follow. `name` is the name after DEF, or empty.
  const lms3dVRMLNode* ParseNode(std::string_view name);
  /// Creates the node. Returns null if it is too deep or exceeds a limit.
  lms3dVRMLNode* BeginNode(std::string_view name);
  void ParseNodeBody(lms3dVRMLNode& node);
  void ParseBodyElement(lms3dVRMLNode& node);
  void ParseField(lms3dVRMLNode& node);
  void EndField(lms3dVRMLNode& node, lms3dVRMLField&& field, bool hasSurfaces);
  void AddField(lms3dVRMLNode& node, lms3dVRMLField&& field);
  void SkipField(const lms3dVRMLNode& node, const lms3dVRMLField& field, bool hasSurfaces);
  /// Parses a node at a position where a field is expected.
  void ParseMisplacedChild(lms3dVRMLNode& node);
  bool IsNodeType(std::string_view name) const;
  bool IsAtNode();
  ///@}

  ///@{
  /// The tokens alone determine the kind of a value. Without a value the result is std::monostate,
  /// with a message. Functions with an argument append to this value.
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
  /// Returns whether the text ends here. Adds a message the first time.
  bool IsAtEnd(std::string_view inside);
  /// Advances past the mark. At another token, returns false and adds a message.
  bool Expect(char mark, std::string_view what);
  /// Skips one token that has no meaning here, with a message.
  void Skip();
  /// Skips from an opening mark to behind the matching closing mark. Does nothing at another token.
  void SkipBlock(char opening, char closing);
  /// Reports the progress. Stops after the user's abort.
  void ReportProgress();
  void Stop();
  /// Returns false, and stops, if the limit of memory is exceeded.
  bool CountMemory(std::size_t bytes);
  /// Returns the name as a view into the names of the document, which outlives the text.
  std::string_view Intern(std::string_view name);
  static std::string Quote(std::string_view text);

  ///@{
  /// Add a message about the current line. Warn adds a warning and ReportLoss an error.
  /// ReportLossHere adds an error if the parsed construct affects surfaces, else a warning.
  void Warn(const std::string& text);
  void ReportLoss(const std::string& text);
  void ReportLossHere(const std::string& text);
  ///@}

  lms3dVRMLLexer Lexer;
  lms3dVRMLDocument& Document;
  lms3dVRMLContext& Context;
  lms3dVRMLScope* Scope = nullptr;
  /// The number of nodes and prototypes around the current token.
  int Depth = 0;
  /// Whether the parsed construct can affect surfaces: false within an Appearance, for example.
  bool AffectsSurfaces = true;
  double ReportedFraction = 0.0;
  /// The number of nodes so far that can be surfaces.
  std::size_t Surfaces = 0;
  bool HasReportedEnd = false;
};

#endif
