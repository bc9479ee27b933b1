# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A real lms3d-server, for tests."""

import contextlib
import os
import random
import resource
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

import giop

SERVER = os.environ["LMS3D_SERVER"]
CLIENT = os.environ["LMS3D_CLIENT"]
PAPER_CLIENT = os.environ["LMS3D_PAPER_CLIENT"]
DATA = Path(os.environ["LMS3D_DATA_DIR"])
BEAMS = 361 * 360


def allow_many_files():
    """Permit a thousand connections of this process."""
    hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))


def find_free_port():
    """A free port of 127.0.0.1, below the ports that the system chooses for connections."""
    with socket.socket() as listener:
        while True:
            port = random.randrange(20000, 32000)
            with contextlib.suppress(OSError):
                listener.bind(("127.0.0.1", port))
                return port


class Server:
    """Runs on Data/room.wrl while the context lasts, with further arguments."""

    def __init__(self, *arguments):
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen(
            [SERVER, "--scenes", DATA, "--scene", "room.wrl", "--position", "0.3", "-0.2", "1",
             "--threads", "1",
             *arguments],
            stdout=subprocess.PIPE, stderr=self.log, text=True)
        self.corbaloc = self.process.stdout.readline().strip()
        self.reference = self.process.stdout.readline().strip()
        if not self.reference.startswith("IOR:"):
            raise RuntimeError("the server is not ready:\n" + self.read_log())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() not in (None, 0):
            print(f"the server ended with {self.process.returncode}:\n{self.read_log()}")
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        self.log.close()

    def stop(self, number=signal.SIGTERM):
        """The exit code and the seconds that it took."""
        start = time.monotonic()
        self.process.send_signal(number)
        code = self.process.wait(60)
        return code, time.monotonic() - start

    def read_log(self):
        """The log up to now. Opened again, because the server writes at the offset of its own file."""
        with open(f"/proc/self/fd/{self.log.fileno()}", encoding="utf-8") as log:
            return log.read()

    def connect(self):
        """A connection without an ORB."""
        return giop.Client(self.corbaloc, timeout=60)

    def count_files(self):
        """Open files, connections among them."""
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def count_threads(self):
        """Running threads."""
        return len(os.listdir(f"/proc/{self.process.pid}/task"))

    def measure_address_space(self):
        """Bytes, with the reserved stacks of threads."""
        pages = Path(f"/proc/{self.process.pid}/statm").read_text().split()[0]
        return int(pages) * resource.getpagesize()

    def measure_memory(self):
        """Resident bytes."""
        pages = Path(f"/proc/{self.process.pid}/statm").read_text().split()[1]
        return int(pages) * resource.getpagesize()


def wait_until(condition, seconds=60, pause=0.05):
    """Whether the condition becomes true in time. `pause` is the time between two checks, seconds."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        with contextlib.suppress(OSError):
            if condition():
                return True
        time.sleep(pause)
    return condition()


def run_client(*arguments, program=CLIENT, **options):
    """The result of lms3d-client."""
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60,
                          check=False, **options)
