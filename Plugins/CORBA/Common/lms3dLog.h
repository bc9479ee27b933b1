// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The server's log and output. They never wait for a reader.
 */
#ifndef lms3dLog_h
#define lms3dLog_h

#include <string>

/// Kinds of lines that clients can cause, each with its own limit; see lms3dLogLimit.
enum class lms3dLogKind
{
  Listeners,
  Scans,
  Scenes,
  VTK
};

/// Writes the time in UTC and a line of text to the standard error, in printable ASCII; see
/// lms3dMakePrintable(). Returns at once: a thread writes, and if the reader does not read, lines
/// are left out and counted. Any thread.
void lms3dLog(const std::string& text);

/// The same, with the limit of the line's kind.
void lms3dLog(lms3dLogKind kind, const std::string& text);

/// Writes lines to the standard output as they are, without waiting for the reader. First waits a
/// moment for earlier lines in the log, so that a reader of both sees them first.
void lms3dPrint(const std::string& lines);

/// Waits until everything is written, half a second at most for each of both streams. Call at the
/// end of the process.
void lms3dFinishLog();

/// Replaces all but printable ASCII by "\n" or, for example, "\x1b", and cuts the text after 1,000
/// characters. So a text from a client cannot forge lines or control a terminal.
std::string lms3dMakePrintable(const std::string& text);

#endif
