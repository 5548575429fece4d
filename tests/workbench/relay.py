"""A wire between the browser and the program that can be cut and joined again.

    with Relay(fem) as wire: ... wire.url ... wire.cut() ... wire.join()
"""

import contextlib
import socket
import threading


class Relay:
    def __init__(self, fem):
        self.fem = fem
        self.ends = []
        self.port = 0
        self.join()
        self.url = f"http://127.0.0.1:{self.port}/{fem.token}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.cut()

    def join(self):
        """Listens at the port that it had, if it had one."""
        self.listener = socket.socket()
        self.listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.listener.bind(("127.0.0.1", self.port))
        self.port = self.listener.getsockname()[1]
        self.listener.listen(64)
        threading.Thread(target=self.accept, args=(self.listener,), daemon=True).start()

    def cut(self):
        """Nobody answers any more."""
        for end in [self.listener, *self.ends]:
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()
        self.ends.clear()

    def accept(self, listener):
        # The program answers to its own name alone: the port in it is exchanged, which has as many digits.
        names = [f"127.0.0.1:{port}".encode() for port in (self.port, self.fem.port)]
        with contextlib.suppress(OSError):
            while True:
                near, _ = listener.accept()
                far = socket.create_connection(("127.0.0.1", self.fem.port))
                self.ends += [near, far]
                for one, other, by in ((near, far, names), (far, near, None)):
                    threading.Thread(target=self.pump, args=(one, other, by), daemon=True).start()

    @staticmethod
    def pump(one, other, names):
        with contextlib.suppress(OSError):
            while piece := one.recv(1 << 16):
                other.sendall(piece.replace(*names) if names else piece)
        for end in (one, other):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
