#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Files of lms3d emulate: its link, and the angles of the platform."""

import fcntl
import os
import shutil
import subprocess
import sys
import time
import unittest

from command_line import POSE, ROOM, CommandLineTest
from emulator_process import EmulatorProcess, PortHost

TURNS = ("--beta-resolution", 4)
# Linux; Python 3.9 has no name for it.
SET_PIPE_SIZE = getattr(fcntl, "F_SETPIPE_SZ", 1031)


def receive(port, count):
    """Receive a number of requested scans."""
    with PortHost(port) as host:
        for _ in range(count):
            host.ask(0x30, 1)


class TestLink(CommandLineTest):
    def refuse(self, link):
        return self.refused(1, "emulate", ROOM, *POSE, "--link", link)

    def test_a_link_of_an_earlier_run_is_replaced(self):
        link = self.folder / "lms200"
        link.symlink_to("/dev/pts/nowhere")
        with EmulatorProcess(ROOM, *POSE, "--link", link) as first:
            with EmulatorProcess(ROOM, *POSE, "--link", link) as second:
                self.assertEqual(os.readlink(link), second.port)
                first.process.terminate()
                first.finish()
                self.assertEqual(os.readlink(link), second.port)
        self.assertFalse(os.path.lexists(link))

    def test_another_file_stays(self):
        for name, target in (("null", "/dev/null"), ("folder", self.folder), ("gone", "nowhere")):
            link = self.folder / name
            link.symlink_to(target)
            self.assertIn("something else has this name", self.refuse(link))
            self.assertEqual(os.readlink(link), str(target))
        taken = self.folder / "taken"
        taken.write_text("text")
        self.assertIn("something else has this name", self.refuse(taken))
        self.assertEqual(taken.read_text(), "text")

    def test_no_folder(self):
        self.assertIn("there is no folder", self.refuse(self.folder / "no" / "link"))
        self.refuse("")

    def test_a_folder_that_is_not_writable(self):
        """Root may write to every folder; but in a folder of the kernel, making the link fails."""
        folder = self.folder / "closed"
        folder.mkdir(mode=0o555)
        if os.access(folder, os.W_OK):
            self.assertIn("cannot make the link '/proc/lms200'", self.refuse("/proc/lms200"))
        else:
            self.assertIn(f"the folder '{folder}' is not writable", self.refuse(folder / "link"))


class TestAngles(CommandLineTest):
    def test_lines(self):
        """They pair with telegrams by both indices; the command's lines go to the errors."""
        with EmulatorProcess(ROOM, *POSE, *TURNS, "--angles", "-",
                             stderr=subprocess.PIPE) as emulator:
            port = next(line.split()[1].rstrip(",") for line in emulator.process.stderr
                        if line.startswith("port"))
            before = time.time()
            with PortHost(port) as host:
                host.ask(0x20, 0x00, *b"SICK_LMS")
                host.ask(0x77, 0, 0, 0x70, 0, 2, 0, 1)
                indices = [tuple(host.ask(0x30, 1)[-2:]) for _ in range(5)]
            emulator.process.terminate()
            lines, _ = emulator.process.communicate(timeout=30)
        header, *rows = lines.splitlines()
        self.assertEqual(header, "turn,telegram,time,angle")
        rows = [row.split(",") for row in rows]
        self.assertEqual([(int(turn), int(telegram)) for turn, telegram, _, _ in rows], indices)
        self.assertEqual([row[3] for row in rows], ["0.0", "90.0", "180.0", "270.0", "0.0"])
        for row in rows:
            self.assertTrue(before - 1 < float(row[2]) < time.time())

    def test_a_reader_that_has_gone(self):
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run([sys.executable, "-m", "lms3d", "emulate", str(ROOM), *map(str, POSE),
                               "--angles", "-"], stdout=writer, stderr=subprocess.PIPE, text=True,
                              timeout=60, check=False)
        os.close(writer)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write the angles to the standard output: Broken pipe", done.stderr)


class TestFilesOfAngles(CommandLineTest):
    def test_a_file_that_is_read(self):
        """It is not overwritten, by any of its names."""
        scan, scene = self.folder / "scan.vtp", self.folder / "scene.wrl"
        self.done("scan", ROOM, *POSE, *TURNS, "-o", scan)
        shutil.copy(ROOM, scene)
        for name, source, words in (("scene", scene, (scene, *POSE)),
                                    ("scan", scan, ("--scan", scan)),
                                    ("trajectory", scan, (ROOM, "--trajectory", scan))):
            before = source.read_bytes()
            hard, soft = (self.folder / f"{name}.{kind}" for kind in ("hard", "soft"))
            os.link(source, hard)
            soft.symlink_to(source)
            for angles in (source, hard, soft):
                with self.subTest(angles.name):
                    problem = self.refused(2, "emulate", *words, "--angles", angles)
                    self.assertIn(f"is both {name} and angles", problem)
                    self.assertEqual(source.read_bytes(), before)

    def test_the_name_of_the_link(self):
        path = self.folder / "both"
        self.assertIn("is both angles and link", self.refused(
            2, "emulate", ROOM, *POSE, "--link", path, "--angles", path))

    def test_no_folder(self):
        self.assertIn("there is no folder", self.refused(
            1, "emulate", ROOM, *POSE, "--angles", self.folder / "no" / "file"))

    def start_with_pipe(self):
        """An emulator whose angles go to a pipe with room for few lines, and the pipe's reader."""
        path = self.folder / "pipe"
        if not path.exists():
            os.mkfifo(path)
        reader = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        fcntl.fcntl(reader, SET_PIPE_SIZE, 4096)
        return EmulatorProcess(ROOM, *POSE, *TURNS, "--angles", path), reader

    def test_lines_after_the_host_has_left(self):
        """A slow reader gets the lines that waited for it."""
        emulator, reader = self.start_with_pipe()
        with emulator:
            receive(emulator.port, 6)
            time.sleep(0.2)
            text, end = b"", time.monotonic() + 20
            while text.count(b"\n") < 7 and time.monotonic() < end:
                text += read_now(reader)
                time.sleep(0.02)
            angles = [line.split(",")[3] for line in text.decode().splitlines()]
            self.assertEqual(angles, ["angle", "0.0", "90.0", "180.0", "270.0", "0.0", "90.0"])

    def test_lines_that_are_not_read(self):
        emulator, reader = self.start_with_pipe()
        with emulator:
            receive(emulator.port, 50)
            emulator.process.terminate()
            code, text = emulator.finish()
        self.assertEqual(code, 0)
        lines = read_now(reader).count(b"\n")
        self.assertIn(f"was not read; the last {51 - lines} lines of angles are lost", text)


def read_now(reader):
    """What a pipe has."""
    try:
        return os.read(reader, 65536)
    except BlockingIOError:
        return b""


if __name__ == "__main__":
    unittest.main()
