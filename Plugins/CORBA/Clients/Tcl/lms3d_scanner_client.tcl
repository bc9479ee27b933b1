#!/usr/bin/env tclsh
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
#
# lms3d_scanner_client.tcl REFERENCE X Y Z
#
# Moves the sensor, waits for a scan that was made wholly from there, and prints range (metres), alpha
# and beta (degrees) of each beam, a line each. The reference is an IOR or a corbaloc.

source [file join [file dirname [info script]] lms3d_types.tcl]

proc connect {reference} {
  set scanner [corba::string_to_object $reference]
  # Combat has to ask for the type, which a corbaloc does not tell.
  if {![$scanner _is_a IDL:LMS3D/LaserScanner:1.0]} {
    error "what is at $reference is no scanner of LMS3D"
  }
  return $scanner
}

# Returns the generation of the scans from there, the first of which is made then. double() since Combat
# would send what is no number as some number.
proc move {scanner x y z} {
  set pose [$scanner getPose]
  dict set pose position [list x [expr {double($x)}] y [expr {double($y)}] z [expr {double($z)}]]
  set generation [$scanner setPose $pose]
  $scanner waitForScan 0 $generation 10000
  return $generation
}

# An angle of an axis, as LMS3DScanner.idl describes it.
proc angle {axis i} {
  dict with axis {
    set is_circle [expr {abs($stop - $start - 360) <= 1e-6}]
    set steps [expr {max(1, $is_circle ? $count : $count - 1)}]
    expr {$start + ($stop - $start) * $i / $steps}
  }
}

proc print_scan {scan} {
  set alpha [dict get $scan header settings alpha]
  set beta [dict get $scan header settings beta]
  set beam 0
  foreach range [dict get $scan beamRanges] {
    set turn [expr {$beam / [dict get $alpha count]}]
    set elevation [expr {$beam % [dict get $alpha count]}]
    puts "$range\t[angle $alpha $elevation]\t[angle $beta $turn]"
    incr beam
  }
}

if {$argc != 4} {
  puts stderr "Usage: lms3d_scanner_client.tcl REFERENCE X Y Z"
  exit 2
}
# Combat waits in Tcl's event loop, and for ever: this notices a server that hangs.
after 30000 {
  puts stderr "lms3d_scanner_client: the server does not answer"
  exit 1
}
corba::init
corba::try {
  lassign $argv reference x y z
  set scanner [connect $reference]
  set generation [move $scanner $x $y $z]
  set scan [$scanner getScan]
  if {[dict get $scan header generation] != $generation} {
    error "another client has changed the settings meanwhile"
  }
  print_scan $scan
} catch {IDL:LMS3D/InvalidArgument:1.0 problem} {
  puts stderr "lms3d_scanner_client: InvalidArgument: [dict get [lindex $problem 1] reason]"
  exit 1
} catch {... problem} {
  # Any other exception: its repository identifier and its members.
  puts stderr "lms3d_scanner_client: $problem"
  exit 1
}
