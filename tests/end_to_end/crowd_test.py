"""Drives `cutaway serve` as a crowd does: clients that send without end, that hold everything, that share, that come back.

Usage: crowd_test.py CUTAWAY_BINARY [unittest arguments]
"""

import socket
import tempfile
import threading
import time
import unittest

from served import HEAD, KNEES, ServedTest, run, serve
from wire import GENEROUS_S, Client, Closed

HEADER = b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nTransfer-Encoding: chunked\r\n\r\n"
ENDLESS = {
    "a chunk extension": HEADER + b"1;",
    "trailers": HEADER + b"0\r\nname: ",
    "a header": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nname: ",
    "a target": b"GET /",
    "a method": b"",
}
BLOCK = b"x" * 65536
EACH_BYTES = 32 << 20  # of each of 4 connections
MOST_GROWTH_BYTES = 20_000_000


def configured(text):
    """A server with this configuration."""
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text)
        file.flush()
        return serve("--config", file.name)


def send_without_end(port, beginning):
    """Until the server has had enough, or all is sent."""
    with socket.create_connection(("127.0.0.1", port), timeout=GENEROUS_S) as connection:
        try:
            connection.sendall(beginning)
            for _ in range(EACH_BYTES // len(BLOCK)):
                connection.sendall(BLOCK)
        except (BrokenPipeError, ConnectionResetError):
            pass


class EndlessTest(ServedTest):
    def test_a_request_without_end_takes_no_memory(self):
        client = self.showing()
        for name, beginning in ENDLESS.items():
            with self.subTest(name):
                self.assertLess(self.growth(beginning), MOST_GROWTH_BYTES)
                self.assertEqual(self.server.get("/healthz")[0], 200)
        client.frame(client.scene({"lens": {"radius_mm": 30}}))

    def growth(self, beginning):
        before = most = self.server.resident_bytes()
        flood = [threading.Thread(target=send_without_end, args=(self.server.port, beginning)) for _ in range(4)]
        for thread in flood:
            thread.start()
        while any(thread.is_alive() for thread in flood):
            most = max(most, self.server.resident_bytes())
            flood[0].join(0.02)
        return most - before


class CrowdTest(unittest.TestCase):
    def server(self, settings):
        server = configured("[server]\n" + settings)
        self.addCleanup(server.stop)
        return server

    def client(self, server, source):
        client = Client(server.port, source)
        self.addCleanup(client.close)
        return client

    def placed(self, server, source):
        """One that has a seat or waits for one."""
        client = self.client(server, source)
        client.receive()
        return client

    def admitted(self, server, source):
        """One that asks again until the full queue has a place for it."""
        while True:
            client = self.client(server, source)
            try:
                client.text("capabilities")
                return client
            except Closed as closed:
                self.assertEqual(closed.code, 1013)
                client.close()
                time.sleep(0.2)

    def test_who_holds_every_seat_and_place_leaves_room_for_another(self):
        server = self.server("limit_loopback = true\nshare_wait_ms = 1000\n")
        holders = [self.placed(server, "127.0.0.2") for _ in range(164)]
        with self.assertRaises(Closed) as refused:
            self.client(server, "127.0.0.2").text("capabilities")
        self.assertEqual(refused.exception.code, 1013)
        self.assertIn(b'"full":true', server.get("/readyz")[2])
        for holder in holders[:64]:
            holder.send(type="presence", visible=True)
        honest = self.client(server, "127.0.0.3")
        honest.text("capabilities")
        honest.send(type="presence", visible=True)
        honest.open(HEAD)
        honest.rest()

    def test_silent_holders_from_many_addresses_leave_room_as_well(self):
        server = self.server("limit_loopback = true\nidle_seat_ms = 3000\nsessions = 8\nqueued_sessions = 8\n")
        for number in range(16):
            self.placed(server, f"127.0.1.{number + 1}")
        honest = self.admitted(server, "127.0.0.3")
        honest.send(type="presence", visible=True)
        honest.open(HEAD)
        honest.rest()

    def test_a_session_that_gave_way_is_had_again_in_its_turn(self):
        server = self.server("sessions = 1\nidle_seat_ms = 1000\n")
        first = self.client(server, "127.0.0.1")
        first.open(HEAD)
        second = self.client(server, "127.0.0.1")
        self.assertEqual(first.text("error")["code"], "gave-way")
        with self.assertRaises(Closed) as ended:
            first.text("nothing more")
        self.assertEqual(ended.exception.code, 4000)
        second.text("capabilities")
        second.send(type="presence", visible=True)
        second.open(KNEES)  # so that its presence has been heard
        again = self.client(server, "127.0.0.1")
        self.assertEqual(again.text("queued")["place"], 1)
        second.close()
        again.text("capabilities")
        again.open(HEAD)
        again.rest()

    def test_the_log_has_one_line_a_second_for_those_that_are_dropped(self):
        server = self.server("sessions = 1\nqueued_sessions = 0\n")
        self.client(server, "127.0.0.1").text("capabilities")
        began = time.monotonic()
        for _ in range(200):
            self.client(server, "127.0.0.1").text("error")
        server.await_words("turned away")
        self.assertLessEqual(server.output().count("turned away"), time.monotonic() - began + 1)

    def test_two_users_at_once_see_their_own_scenes_and_outlive_a_restart(self):
        server = self.server("")
        one, other = self.client(server, "127.0.0.1"), self.client(server, "127.0.0.1")
        one.open(HEAD)
        other.open(KNEES)
        for radius_mm in (20, 30, 40):
            inputs = [each.scene({"lens": {"radius_mm": radius_mm}}) for each in (one, other)]
            for each, number in zip((one, other), inputs):
                each.frame(number)
        self.assertEqual([each.text("scene")["scene"]["volume"] for each in self.resolved(one, other)], [HEAD, KNEES])
        self.assertEqual(server.stop(), 0)
        for each in (one, other):
            with self.assertRaises(Closed) as ended:
                each.text("nothing more")
            self.assertEqual(ended.exception.code, 1001)
        renewed = self.server("")
        again = self.client(renewed, "127.0.0.1")
        again.open(KNEES)
        again.rest()

    @staticmethod
    def resolved(*clients):
        """Each is told its whole scene."""
        for client in clients:
            client.scene({"lens": {"centre_mm": None}})
        return clients


if __name__ == "__main__":
    run()
