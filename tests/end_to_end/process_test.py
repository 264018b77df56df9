"""The server as a process: signals, standard streams that nobody reads, threads that are not to be had.

Usage: process_test.py CUTAWAY_BINARY [unittest arguments]
"""

import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

from wire import GENEROUS_S, Client, Closed, Server

BINARY = None
GOING_AWAY = 1001
SMALL = "phantom:head@32"


def send(server, *signals):
    for each in signals:
        server.process.send_signal(each)


def closing_code(client):
    """Reads on until the other side ends the connection."""
    try:
        while client.receive() is not None:
            pass
    except Closed as closed:
        return closed.code
    raise AssertionError("the connection was not closed")


class Started(unittest.TestCase):
    def start(self, *arguments, **process):
        server = Server(BINARY, *arguments, **process)
        self.addCleanup(server.stop)
        return server

    def client_of(self, server):
        client = Client(server.port)
        self.addCleanup(client.close)
        client.open(SMALL)
        client.rest()
        return client


class SignalTest(Started):
    def test_interrupt_terminate_and_quit_say_goodbye_to_every_session(self):
        for each in (signal.SIGINT, signal.SIGTERM, signal.SIGQUIT):
            with self.subTest(each.name):
                server = self.start()
                clients = [self.client_of(server) for _ in range(2)]
                send(server, each)
                self.assertEqual([closing_code(client) for client in clients], [GOING_AWAY] * 2)
                self.assertEqual(server.process.wait(GENEROUS_S), 0)

    def test_a_second_signal_ends_it_at_once(self):
        config = tempfile.NamedTemporaryFile("w", suffix=".toml")
        self.addCleanup(config.close)
        config.write(f"[server]\nstop_timeout_ms = {int(1000 * GENEROUS_S)}\n")
        config.flush()
        server = self.start("--config", config.name)
        self.client_of(server)  # never answers the closing handshake, so that the server waits for it
        send(server, signal.SIGTERM)
        server.await_words("stopping")
        send(server, signal.SIGINT)
        self.assertEqual(server.process.wait(GENEROUS_S / 2), -signal.SIGINT)

    def test_stray_signals_are_survived(self):
        server = self.start()
        client = self.client_of(server)
        send(server, signal.SIGHUP, signal.SIGUSR1, signal.SIGUSR2, signal.SIGPIPE)
        client.viewport(200, 100)
        self.assertEqual(client.rest().viewport, (200, 100))
        self.assertIsNone(server.process.poll())


class StandardStreamTest(Started):
    def assert_serves(self, server):
        self.client_of(server)
        self.assertEqual(server.get("/healthz")[0], 200)
        self.assertIsNone(server.process.poll())

    def test_a_standard_error_that_nobody_reads_any_more_costs_nothing(self):
        reading, writing = os.pipe()
        server = self.start(stderr=writing)
        os.close(writing)
        os.close(reading)
        for _ in range(3):
            self.assert_serves(server)
        send(server, signal.SIGTERM)
        self.assertEqual(server.process.wait(GENEROUS_S), 0)

    def test_a_standard_error_that_is_full_holds_nobody_up(self):
        reading, writing = os.pipe()
        self.addCleanup(os.close, reading)
        server = self.start(stderr=writing)
        self.addCleanup(os.close, writing)
        os.set_blocking(writing, False)
        try:
            while os.write(writing, b"." * 4096):
                pass
        except BlockingIOError:
            os.set_blocking(writing, True)
        for _ in range(3):
            self.assert_serves(server)

    def test_no_connection_gets_what_is_meant_for_a_closed_standard_error(self):
        server = self.start(stderr=None, preexec_fn=lambda: os.close(2))
        links = pathlib.Path(f"/proc/{server.process.pid}/fd")
        self.assertEqual(os.readlink(links / "2"), "/dev/null")
        for _ in range(3):
            self.assert_serves(server)

    def test_the_other_commands_do_without_it_too(self):
        with tempfile.TemporaryDirectory() as folder:
            picture, scene = pathlib.Path(folder) / "out.png", pathlib.Path(folder) / "scene.json"
            scene.write_text("{}")
            reading, writing = os.pipe()
            os.close(reading)
            command = [BINARY, "render", scene, "-o", picture, "--volume", SMALL, "--size", "64x64"]
            done = subprocess.run(command, stderr=writing, timeout=GENEROUS_S)
            os.close(writing)
            self.assertEqual(done.returncode, 0)
            self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))


def as_user_with(threads):
    """What is run in a new process so that it can have so many threads; the limit does not bind root."""

    def prepare():
        if os.getuid() == 0:
            os.setgroups([])
            os.setgid(54321)
            os.setuid(54321)
        resource.setrlimit(resource.RLIMIT_NPROC, (threads, threads))

    return prepare


@unittest.skipUnless(os.getuid() == 0, "only root can be a user who has no other process")
class FewThreadsTest(unittest.TestCase):
    MOST = 400  # more than the server starts on any machine

    def setUp(self):
        folder = tempfile.TemporaryDirectory()  # where that user may read
        self.addCleanup(folder.cleanup)
        os.chmod(folder.name, 0o755)
        self.binary = shutil.copy(BINARY, folder.name)

    def starts(self, threads):
        """Whether the server starts; where not, it ends with words."""
        process = subprocess.Popen(
            [self.binary, "serve", "--listen", "127.0.0.1:0"],
            preexec_fn=as_user_with(threads), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        with process:
            self.addCleanup(process.kill)
            if process.stdout.readline().startswith("Cutaway is at"):
                process.terminate()
                process.communicate(timeout=GENEROUS_S)
                self.assertEqual(process.returncode, 0)
                return True
            errors = process.communicate(timeout=GENEROUS_S)[1]
            self.assertEqual(process.returncode, 1, errors)
            self.assertIn("no more threads can be started", errors)
            self.assertIn(f"now {threads}", errors)
            return False

    def test_it_starts_or_says_why_not(self):
        self.assertTrue(self.starts(self.MOST))
        outcomes = []
        while not any(outcomes):
            outcomes.append(self.starts(len(outcomes) + 1))
        self.assertGreater(len(outcomes), 2)


def may_leave_a_core():
    resource.setrlimit(resource.RLIMIT_CORE, (resource.getrlimit(resource.RLIMIT_CORE)[1],) * 2)


def left_a_core(process):
    """Breaks it down; the kernel tells whether its memory was written anywhere."""
    process.send_signal(signal.SIGSEGV)
    return os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT).si_code == os.CLD_DUMPED


class CoreDumpTest(Started):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.process = {"cwd": folder.name, "preexec_fn": may_leave_a_core}
        self.config = pathlib.Path(folder.name) / "config.toml"
        any_process = subprocess.Popen(["sleep", "1000"], **self.process)
        if not left_a_core(any_process):
            any_process.wait()
            self.skipTest("no process leaves a core file here")
        any_process.wait()

    def left_by_server(self, *arguments):
        server = self.start(*arguments, **self.process)
        self.client_of(server)
        return left_a_core(server.process)

    def test_patients_images_are_not_left_on_a_disk(self):
        self.assertFalse(self.left_by_server())

    def test_who_wants_a_core_gets_one(self):
        self.config.write_text("[process]\ncore_dumps = true\n")
        self.assertTrue(self.left_by_server("--config", self.config))


if __name__ == "__main__":
    BINARY = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
