# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
#
# LMS3D.idl and LMS3DScanner.idl for Combat, without the listeners: a client that only asks has no use
# for them. Combat's idl2tcl would write this, but needs an interface repository to read from.

package require combat

# The words of IDL, in terms of combat::ir.
namespace eval lms3d {
  proc id {name} { return IDL:LMS3D/$name:1.0 }
  proc describe {name} { list [id $name] [file tail $name] 1.0 }

  # Types of IDL itself begin with a small letter.
  proc type {words} {
    lmap word $words { expr {[string match {[A-Z]*} $word] ? [id $word] : $word} }
  }
  proc members {declarations} {
    set members {}
    foreach {type names} $declarations {
      foreach name $names { lappend members [list $name [type $type]] }
    }
    return $members
  }

  proc typedef {type name} {
    combat::ir add [list [list typedef [describe $name] [type $type]]]
  }
  proc enum {name values} {
    combat::ir add [list [list enum [describe $name] $values]]
  }
  proc struct {name declarations} {
    combat::ir add [list [list struct [describe $name] [members $declarations] {}]]
  }
  proc exception {name declarations} {
    combat::ir add [list [list exception [describe $name] [members $declarations] {}]]
  }
  proc interface {name bases operations} {
    set contents {}
    foreach {result operation parameters raises exceptions} $operations {
      set inputs [lmap member [members $parameters] { linsert $member 0 in }]
      lappend contents [list operation [describe $name/$operation] [type $result] $inputs \
        [type $exceptions]]
    }
    combat::ir add [list [list interface [describe $name] [type $bases] $contents]]
  }
}

namespace eval lms3d {
  typedef {sequence float} Data
  interface DataExchange {} {
    Data fetch {} raises {}
  }

  typedef {string 128} SceneName
  typedef {sequence SceneName 4096} SceneNames
  typedef {string 512} Text

  exception InvalidArgument { Text reason }
  exception LimitExceeded { Text reason {unsigned long long} limit }
  exception NoSuchScene { SceneName name }
  exception SceneFailed { SceneName name Text reason }
  exception NoScanYet { {unsigned long long} newest }
  exception ScanGone { {unsigned long long} {oldest newest} }
  exception NotPermitted { Text reason }

  struct Vector3 { double {x y z} }
  struct Pose { Vector3 {position orientation} }
  struct Axis { double {start stop} {unsigned long} count }
  enum IntersectionMethod {METHOD_EXACT METHOD_FAST}
  struct Configuration {
    Axis {alpha beta}
    double {minimumRange maximumRange}
    IntersectionMethod method
    boolean makeMap
    double mapError
  }
  struct ScanHeader {
    {unsigned long long} {number incarnation generation startTime endTime}
    SceneName scene
    Pose sensorPose
    Configuration settings
    {unsigned long} {beams returns mapPoints mapTriangles rangesChecksum mapChecksum}
  }
  typedef Data Ranges
  typedef {sequence double} Coordinates
  typedef {sequence {unsigned long}} Indices
  struct Scan { ScanHeader header Ranges beamRanges }
  struct Scene { SceneName name {unsigned long long} triangles Vector3 {lowest highest} }
  struct Status {
    Text version
    {unsigned long long} {incarnation generation newest}
    double rate
    {unsigned long long} lateScans
    double {scanSeconds mapSeconds}
    boolean {isReadOnly hasCallbacks}
    {unsigned long} {waiting listening}
    Text problem
  }

  interface LaserScanner DataExchange {
    Pose getPose {} raises {}
    {unsigned long long} setPose { Pose newPose } raises {InvalidArgument NotPermitted}
    Configuration getConfiguration {} raises {}
    {unsigned long long} setConfiguration { Configuration newConfiguration }
      raises {InvalidArgument LimitExceeded NotPermitted}
    SceneNames listScenes {} raises {}
    Scene getScene {} raises {}
    {unsigned long long} selectScene { SceneName name }
      raises {NoSuchScene SceneFailed LimitExceeded NotPermitted}
    Status getStatus {} raises {}
    ScanHeader getHeader {} raises {NoScanYet}
    ScanHeader waitForScan { {unsigned long long} {after generation} {unsigned long} timeout }
      raises {NoScanYet LimitExceeded}
    Scan getScan {} raises {NoScanYet LimitExceeded}
    Ranges getRanges { {unsigned long long} number {unsigned long} {first count} }
      raises {ScanGone InvalidArgument LimitExceeded}
    Coordinates getMapPoints { {unsigned long long} number {unsigned long} {first count} }
      raises {ScanGone InvalidArgument LimitExceeded}
    Indices getMapTriangles { {unsigned long long} number {unsigned long} {first count} }
      raises {ScanGone InvalidArgument LimitExceeded}
  }
}
