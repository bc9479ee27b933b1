#!/usr/bin/env tclsh
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
#
# lms3d_paper_client.tcl REFERENCE
#
# Fetches a scan by the paper's interface and prints range (metres), alpha and beta (degrees) of each
# beam, a line each. The reference is an IOR or a corbaloc.

package require combat

# All of LMS3D.idl. Combat's idl2tcl would write it, but needs an interface repository to read from.
combat::ir add {
  {module {IDL:LMS3D:1.0 LMS3D 1.0} {
    {typedef {IDL:LMS3D/Data:1.0 Data 1.0} {sequence float}}
    {interface {IDL:LMS3D/DataExchange:1.0 DataExchange 1.0} {} {
      {operation {IDL:LMS3D/DataExchange/fetch:1.0 fetch 1.0} IDL:LMS3D/Data:1.0 {} {}}
    }}
  }}
}

if {$argc != 1} {
  puts stderr "Usage: lms3d_paper_client.tcl REFERENCE"
  exit 2
}
# Combat waits in Tcl's event loop, and for ever: this notices a server that hangs.
after 30000 {
  puts stderr "lms3d_paper_client: the server does not answer"
  exit 1
}
corba::init
corba::try {
  set scanner [corba::string_to_object [lindex $argv 0]]
  # A corbaloc tells no type, and an IOR one that the paper does not know: Combat has to ask.
  if {![$scanner _is_a IDL:LMS3D/DataExchange:1.0]} {
    error "what is at [lindex $argv 0] is no scanner of LMS3D"
  }
  foreach {range alpha beta} [$scanner fetch] {
    puts "$range\t$alpha\t$beta"
  }
} catch {... problem} {
  puts stderr "lms3d_paper_client: $problem"
  exit 1
}
