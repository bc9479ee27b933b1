# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The C++ clients as a user starts them."""

import array
import resource
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

from server_process import BEAMS, CLIENT, PAPER_CLIENT, Server, run_client, wait_until


def count_listeners(server):
    """The last number of the status."""
    with server.connect() as client:
        status = client.call("getStatus")
    status.string()
    for code, count in (("Q", 3), ("d", 1), ("Q", 1), ("d", 2), ("B", 2)):
        status.numbers(code, count)
    return status.numbers("I", 2)[1]


class ClientTest(unittest.TestCase):
    """The two C++ clients."""

    def setUp(self):
        self.server = self.enterContext(Server("--callbacks"))
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def run_client(self, *arguments):
        """The output of a successful client."""
        finished = run_client(self.server.corbaloc, *arguments)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual(finished.stderr, "")
        return finished.stdout

    def test_paper_client(self):
        """Compiled from the paper's interface alone."""
        finished = run_client(self.server.corbaloc, program=PAPER_CLIENT)
        self.assertEqual(finished.stdout, f"{BEAMS} beams, {BEAMS} returns\n"
                         "nearest: r 1 m, alpha -90, beta 0 degrees\n")

    def test_looks(self):
        """Status, scenes, scans."""
        self.assertIn("scene room.wrl, 804 triangles", self.run_client("status"))
        self.assertEqual(self.run_client("scenes"), "building.wrl\nroom.wrl\nteapot.wrl\n")
        self.assertEqual(len(self.run_client("fetch").splitlines()), BEAMS + 1)
        self.assertEqual(len(self.run_client("watch", "3").splitlines()), 3)
        self.assertEqual(len(self.run_client("listen", "3").splitlines()), 3)

    def test_fetch_prints_all_digits(self):
        """Parsing the output yields the floats that were sent."""
        words = "\t".join(self.run_client("fetch").splitlines()[1:]).split("\t")
        with self.server.connect() as client:
            self.assertEqual(array.array("f", map(float, words)), array.array("f", client.fetch()))

    def test_help(self):
        """The client prints it, with or without a server."""
        for arguments in (("--help",), (self.server.corbaloc, "--help")):
            finished = run_client(*arguments)
            self.assertEqual(finished.returncode, 0)
            self.assertIn("save SCAN.vtp [MAP.vtp]", finished.stdout)
            self.assertEqual(finished.stderr, "")

    def test_changes(self):
        """The client prints the first scan after the change."""
        self.assertIn("from 1 0.5 1.2:", self.run_client("pose", "1", "0.5", "1.2"))
        self.assertIn("of teapot.wrl", self.run_client("scene", "teapot.wrl"))

    def test_device(self):
        """The client prints it, selects a preset, and sets single properties."""
        self.assertEqual(self.run_client("presets"), "ideal\nlms200-mm\nlms200-cm\nlms291\n")
        self.assertIn("rangeNoise 0 m\n", self.run_client("device"))
        self.assertIn("of room.wrl", self.run_client("device", "lms200-cm"))
        self.assertIn("of room.wrl", self.run_client("set", "noiseSeed", "-3"))
        for words in ("rangeNoise 0", "rangeResolution 0"):
            self.run_client("set", *words.split())
        for words in ("mounting pitching", "axisOffset 0 0.25 -0.5", "computeStatus on"):
            self.assertIn("of room.wrl", self.run_client("set", *words.split()))
        printed = self.run_client("device").splitlines()
        for line in ("rangeNoise 0 m", "noiseSeed -3", "beamDiameter 0.012 m", "beamSamples 7 rays",
                     "mounting pitching", "axisOffset 0 0.25 -0.5 m", "turnRate 0 deg/s",
                     "computeStatus on"):
            self.assertIn(line, printed)

    def test_saves(self):
        """Scan and map as VTK's files."""
        scan, surface = self.folder / "scan.vtp", self.folder / "map.vtp"
        self.run_client("save", scan, surface)
        self.assertIn(b'NumberOfPoints="%d"' % BEAMS, scan.read_bytes())
        self.assertIn(b'NumberOfPolys="1184"', surface.read_bytes())
        self.assertEqual(sorted(self.folder.iterdir()), [surface, scan])

    def test_fused_map(self):
        """The map of many scans is saved, watched and begun anew."""
        self.server = self.enterContext(Server("--fused-map", "0.02"))
        surface = self.folder / "fused.vtp"
        self.assertIn("map of 1 scans of room.wrl", self.run_client("fused", surface))
        self.assertIn(b'Name="RegionId"', surface.read_bytes())
        self.run_client("pose", "1", "0.5", "1.2")
        self.assertRegex(self.run_client("grow", "1"), "^map of 2 scans of .*: all .* bytes")
        self.assertIn("from 1 0.5 1.2:", self.run_client("reset"))
        self.assertIn("map of 1 scans", self.run_client("fused", surface))

    def test_what_cannot_be_saved(self):
        """No temporary file is left, and an existing file stays unchanged."""
        scan = self.folder / "scan.vtp"
        scan.write_text("before")
        for names, words in ((("/no/such/folder/x.vtp",), "no folder"), ((self.folder,), ".vtp"),
                             ((scan, self.folder / "map.stl"), ".vtp"),
                             ((scan, f"{self.folder}/../{self.folder.name}/scan.vtp"), "both files")):
            finished = run_client(self.server.corbaloc, "save", *names)
            self.assertEqual(finished.returncode, 1)
            self.assertRegex(finished.stderr, f"cannot write.*{words}")
            self.assertEqual(list(self.folder.iterdir()), [scan])
            self.assertEqual(scan.read_text(), "before")

    def test_a_file_is_replaced_as_a_whole(self):
        """If the file cannot be written completely, the existing one stays unchanged."""
        scan = self.folder / "scan.vtp"
        scan.write_text("before")
        # Python ignores the signal of this limit, and so does the client then.
        finished = run_client(self.server.corbaloc, "save", scan, restore_signals=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (9999,) * 2))
        self.assertEqual(finished.returncode, 1)
        self.assertEqual(finished.stderr,
                         f'lms3d-client: cannot write "{scan}": File too large\n')
        self.assertEqual(list(self.folder.iterdir()), [scan])
        self.assertEqual(scan.read_text(), "before")
        self.run_client("save", scan)
        self.assertIn(b'NumberOfPoints="%d"' % BEAMS, scan.read_bytes())

    def test_ctrl_c_leaves_no_file(self):
        """Not even while the client writes. A slow test may see the file too late."""
        scan = self.folder / "scan.vtp"
        self.assertTrue(any(self.interrupt_save(scan) for _ in range(50)))

    def interrupt_save(self, scan):
        """Whether Ctrl-C came while the temporary file was there."""
        with subprocess.Popen([CLIENT, self.server.corbaloc, "save", scan]) as client:
            temporary = self.folder / f".scan.{client.pid}.vtp"
            while client.poll() is None and not temporary.exists():
                pass
            client.send_signal(signal.SIGINT)
        self.assertIn(client.returncode, (0, -signal.SIGINT))
        self.assertFalse(temporary.exists())
        is_saved = scan.exists()
        scan.unlink(missing_ok=True)
        return client.returncode == -signal.SIGINT and not is_saved

    def test_another_file_has_the_temporary_name(self):
        """The client neither follows a link nor removes the file."""
        other = self.folder / "other"
        other.write_text("before")
        # The shell's process becomes the client's.
        script = 'ln -s other "$1/.scan.$$.vtp"; exec "$2" "$3" save "$1/scan.vtp"'
        finished = subprocess.run(
            ["sh", "-c", script, "sh", self.folder, CLIENT, self.server.corbaloc],
            capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(finished.returncode, 1)
        self.assertRegex(finished.stderr, r'cannot write ".*/\.scan\.\d+\.vtp": File exists')
        self.assertEqual(other.read_text(), "before")
        self.assertEqual(len(list(self.folder.iterdir())), 2)

    def test_failures(self):
        """A message and an exit code. Wrong arguments are reported without a server."""
        unused = "corbaloc:iiop:1.2@127.0.0.1:1/LMS3D"
        for arguments, code, word in (
                ((self.server.corbaloc, "scene", "../room.wrl"), 1, "NoSuchScene"),
                ((self.server.corbaloc, "pose", "nan", "0", "0"), 1, "position is nan"),
                ((self.server.corbaloc, "pose", "0", "a", "0"), 2, 'Y: "a" is not a number'),
                ((self.server.corbaloc, "pose", *"00000", "1e999"), 2, 'RZ: "1e999" is not'),
                ((self.server.corbaloc, "device", "sick"), 1, "NoSuchPreset"),
                ((self.server.corbaloc, "reset"), 1, "NoFusedMap: the server was started without"),
                ((self.server.corbaloc, "grow", "1"), 1, "NoFusedMap"),
                ((unused, "fused", "map.stl"), 1, "its name must end in .vtp"),
                ((self.server.corbaloc, "set", "rangeNoise", "-1"), 1, "rangeNoise is -1"),
                ((unused, "set", "range", "1"), 2, '"range" is no property'),
                ((unused, "set", "rangeNoise", "x"), 2, 'rangeNoise: "x" is not a number'),
                ((unused, "set", "rangeNoise", "1", "2", "3"), 2, "rangeNoise: it takes 1 value"),
                ((unused, "set", "axisOffset", "1"), 2, "axisOffset: it takes 3 values"),
                ((unused, "set", "mounting", "up"), 2, 'mounting: "up" is none of yawing, '),
                ((unused, "set", "computeStatus", "1"), 2, '"1" is neither on nor off'),
                ((self.server.corbaloc, "watch", "2x"), 2, 'COUNT: "2x" is not a whole number'),
                ((self.server.corbaloc, "listen", "-1"), 2, 'COUNT: "-1" is not a whole number'),
                ((self.server.corbaloc, "jump"), 2, "Usage"), ((), 2, "Usage"),
                ((unused, "status"), 1, "TRANSIENT"),
                ((unused, "jump"), 2, "Usage"), ((unused, "status", "now"), 2, "Usage"),
                ((unused, "pose", "1", "x", "2"), 2, 'Y: "x" is not a number'),
                ((unused, "save", "scan.stl"), 1, "its name must end in .vtp"),
                (("nonsense", "status"), 1, "is neither a corbaloc")):
            finished = run_client(*arguments)
            self.assertEqual(finished.returncode, code, arguments)
            self.assertIn(word, finished.stderr)


class PatienceTest(unittest.TestCase):
    """Clients wait as long as the server lives."""

    def start(self, server, *arguments):
        """A client that waits."""
        client = subprocess.Popen([CLIENT, server.corbaloc, *arguments], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True)
        self.addCleanup(client.stderr.close)
        self.addCleanup(client.stdout.close)
        self.addCleanup(client.wait)
        self.addCleanup(client.kill)
        return client

    def assert_ends(self, client, words):
        """Soon, with a message and the code of a failure."""
        message = client.communicate(timeout=60)[1]
        self.assertEqual(client.returncode, 1)
        self.assertRegex(message, f"^lms3d-client: .*{words}.*\n$")

    def test_scans_that_are_far_apart(self):
        """Scans whose interval exceeds the timeout of every call."""
        with Server("--rate", "0.15") as server:
            finished = run_client(server.corbaloc, "watch", "2")
            self.assertEqual(finished.returncode, 0, finished.stderr)
            self.assertEqual(len(finished.stdout.splitlines()), 2)

    def test_the_end_of_the_server(self):
        """By SIGTERM or SIGKILL, with many or few scans."""
        for rate in ("10", "0.01"):
            for number in (signal.SIGTERM, signal.SIGKILL):
                with self.subTest(rate=rate, number=number):
                    with Server("--callbacks", "--rate", rate) as server:
                        clients = [self.start(server, command) for command in ("listen", "watch")]
                        # Without new settings, the next scan may be far away.
                        self.assertTrue(wait_until(lambda: count_listeners(server) == 1))
                        run_client(server.corbaloc, "pose", "0.5", "0.5", "1")
                        for client in clients:
                            self.assertIn("of room.wrl", client.stdout.readline())
                        server.stop(number)
                        for client in clients:
                            self.assert_ends(client, "no server answers there")

    def test_a_listener_that_cannot_be_reached(self):
        """A listener that publishes an unused port."""
        with Server("--callbacks") as server:
            client = self.start(server, "listen", "-ORBendPointPublish", "giop:tcp:127.0.0.1:1")
            self.assert_ends(client, "does not call this listener")


if __name__ == "__main__":
    unittest.main()
