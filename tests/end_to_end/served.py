"""What the tests that drive `cutaway serve` over the wire share; the wire itself is in wire.py."""

import sys
import unittest

from wire import Client, Server

HEAD = "phantom:head@64"
KNEES = "phantom:knees@64"

_binary = None


def run():
    """Runs the tests of the script that was started; its first argument is the executable."""
    global _binary
    _binary = sys.argv.pop(1)
    unittest.main(module="__main__", verbosity=2)


def serve(*arguments):
    return Server(_binary, *arguments)


class ServedTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = serve()
        cls.addClassCleanup(cls.server.stop)

    def connect(self):
        client = Client(self.server.port)
        self.addCleanup(client.close)
        return client

    def showing(self, volume=HEAD, width_px=320, height_px=240):
        """A client that has seen the refined frame of a volume."""
        client = self.connect()
        client.open(volume, width_px, height_px)
        client.rest()
        return client
