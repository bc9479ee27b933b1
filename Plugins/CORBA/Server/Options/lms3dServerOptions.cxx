// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/lms3dServerOptions.h"

#include "Options/lms3dConfigurationFile.h"
#include "Options/lms3dOptionTable.h"
#include "Options/lms3dOptionsCheck.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace
{
using Words = std::vector<std::string>;

constexpr const char* Description =
  R"(Scans in an endless loop and serves the scans by CORBA, as LMS3DScanner.idl describes. When it
is ready it prints a corbaloc and an IOR, one per line. SIGTERM, SIGINT and SIGHUP end it with
code 0.
)";

constexpr const char* Footer =
  R"(Options of omniORB (-ORBtraceLevel 10) go to the ORB. They, omniORB's environment variables and
its configuration file apply unless an option above sets the same. Only --endpoint names
endpoints, unless --allow-remote is given.

Exit code: 0 ended by a signal, 1 failed while starting, 2 wrong options
)";

// The options that a configuration file must not have.
void AddCommandLineOptions(CLI::App& app, lms3dServerOptions& options, Words& files)
{
  const auto addFile = [&files](const Words& words)
  {
    files.push_back(words[0]);
    return true;
  };
  app
    .add_option("--config", addFile,
      "read options from a file, one per line: \"rate = 5\",\n"
      "\"position = 0.3 -0.2 1\", \"read-only\"; # begins a comment line.\n"
      "The command line overrules the file")
    ->option_text("FILE")
    ->type_name("FILE")
    ->trigger_on_parse();
  app.add_flag("--help", options.Help, "print this text");
  app.add_flag("--version", options.Version, "print the version of LMS3D");
}

// Refuses the value of a flag, and an empty one: CLI11 would take the next option as the value of
// "--name=".
void CheckEqualsSign(const CLI::Option& option, const std::string& value)
{
  if (option.get_items_expected_max() == 0)
  {
    throw std::invalid_argument(option.get_name() + ": it takes no value");
  }
  if (value.empty())
  {
    throw std::invalid_argument(
      option.get_name() + ": a value must follow the \"=\": " + option.get_type_name());
  }
}

// `count` is the number of words after the option.
void CheckCount(const CLI::Option& option, std::size_t count)
{
  const auto expected = static_cast<std::size_t>(option.get_items_expected_max());
  if (count < expected)
  {
    throw std::invalid_argument(option.get_name() + ": " +
      (expected == 1 ? "a value" : std::to_string(expected) + " values") +
      " must follow: " + option.get_type_name());
  }
}

// Throws std::invalid_argument if an option has too few values, or a flag has one.
void CheckValues(const CLI::App& app, const Words& words)
{
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const std::string& word = words[i];
    const std::size_t equals = word.find('=');
    const CLI::Option* const option = app.get_option_no_throw(word.substr(0, equals));
    if (!option)
    {
      continue;
    }
    const bool hasValue = equals != std::string::npos;
    if (hasValue)
    {
      CheckEqualsSign(*option, word.substr(equals + 1));
    }
    const std::size_t first = i + (hasValue ? 0 : 1);
    CheckCount(*option, words.size() - first);
    // The values may look like options.
    i = first + static_cast<std::size_t>(option->get_items_expected_max()) - 1;
  }
}

// Throws std::invalid_argument.
void Parse(CLI::App& app, const Words& words)
{
  CheckValues(app, words);
  try
  {
    // CLI11 expects the words in reverse order.
    app.parse(Words(words.rbegin(), words.rend()));
  }
  catch (const CLI::ExtrasError&)
  {
    throw std::invalid_argument(
      "The following argument was not expected: " + app.remaining().front());
  }
  catch (const CLI::Error& problem)
  {
    throw std::invalid_argument(problem.what());
  }
}

// A line of a file as words of a command line. A single value is the rest of the line, because the
// name of a file may contain blanks.
Words MakeWords(const CLI::App& app, const std::string& line)
{
  const std::size_t equals = line.find('=');
  const std::string name = "--" + lms3dTrim(line.substr(0, equals));
  if (equals == std::string::npos)
  {
    return { name };
  }
  const std::string values = lms3dTrim(line.substr(equals + 1));
  const CLI::Option* const option = app.get_option_no_throw(name);
  const int count = option ? option->get_items_expected_max() : 1;
  if (count == 0)
  {
    return values.empty() ? Words{ name } : throw std::invalid_argument("it takes no value");
  }
  if (count == 1)
  {
    return { name + '=' + values };
  }
  std::istringstream stream(values);
  Words words = { name };
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

// CLI11's own reader of files would split file names at blanks, ignore repeated options and report
// no line numbers.
void ReadFile(const std::string& file, lms3dServerOptions& options)
{
  CLI::App app;
  lms3dAddServerOptions(app, options);
  lms3dReadConfigurationFile(
    file, [&app](const std::string& line) { Parse(app, MakeWords(app, line)); });
}

// Moves each name that begins with -ORB, and its value, out of the arguments.
Words TakeORBArguments(Words& arguments)
{
  Words taken;
  Words left;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    if (arguments[i].rfind("-ORB", 0) != 0)
    {
      left.push_back(arguments[i]);
      continue;
    }
    if (i + 1 == arguments.size())
    {
      throw std::invalid_argument(arguments[i] + ": a value must follow");
    }
    taken.insert(taken.end(), { arguments[i], arguments[i + 1] });
    ++i;
  }
  arguments.swap(left);
  return taken;
}
} // namespace

lms3dServerOptions lms3dReadServerOptions(const std::vector<std::string>& arguments)
{
  lms3dServerOptions options;
  Words words = arguments;
  options.ORBArguments = TakeORBArguments(words);

  CLI::App app;
  Words files;
  lms3dAddServerOptions(app, options);
  AddCommandLineOptions(app, options, files);
  // The first pass finds the files, whose values the second one overrules.
  Parse(app, words);
  lms3dServerOptions fromFiles;
  for (const std::string& file : files)
  {
    ReadFile(file, fromFiles);
  }
  fromFiles.ORBArguments = options.ORBArguments;
  options = std::move(fromFiles);
  Parse(app, words);
  lms3dCheckServerOptions(options);
  return options;
}

std::string lms3dGetServerHelp()
{
  lms3dServerOptions options;
  Words files;
  CLI::App app(Description, "lms3d-server --scenes FOLDER [-ORBNAME VALUE ...]");
  lms3dAddServerOptions(app, options);
  AddCommandLineOptions(app, options, files);
  app.get_formatter()->column_width(32);
  app.footer(Footer);
  return app.help();
}
