"""Home Assistant's WebSocket API, by which its own pages do what an owner does there."""

from __future__ import annotations

import base64
import json
import os
import socket
import struct
from types import TracebackType
from typing import Any

TEXT, PING, PONG = 1, 9, 10


class SocketApi:
    """A connection that has logged in."""

    def __init__(self, port: int, token: str) -> None:
        self.socket = socket.create_connection(("127.0.0.1", port), 60)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(
            f"GET /api/websocket HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
        )
        self.stream = self.socket.makefile("rb")
        while self.stream.readline().strip():
            pass
        self.number = 0
        self._receive()
        self._send({"type": "auth", "access_token": token})
        answer = self._receive()
        if answer["type"] != "auth_ok":
            raise AssertionError(answer)

    def __enter__(self) -> SocketApi:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.stream.close()
        self.socket.close()

    def ask(self, kind: str, **more: Any) -> Any:
        """What Home Assistant answers; an AssertionError if it refuses."""
        self.number += 1
        self._send({"id": self.number, "type": kind, **more})
        while (answer := self._receive()).get("id") != self.number:
            pass
        if not answer["success"]:
            raise AssertionError(f"{kind} {more}: {answer['error']}")
        return answer["result"]

    def _send(self, message: dict[str, Any]) -> None:
        self._frame(TEXT, json.dumps(message).encode())

    def _frame(self, kind: int, content: bytes) -> None:
        size = len(content)
        length = bytes([128 | size]) if size < 126 else bytes([128 | 126]) + struct.pack(">H", size)
        # A mask of zeros changes nothing.
        self.socket.sendall(bytes([128 | kind]) + length + bytes(4) + content)

    def _receive(self) -> Any:
        text = b""
        while True:
            first, size = self.stream.read(2)
            if size > 125:
                width, form = (2, ">H") if size == 126 else (8, ">Q")
                (size,) = struct.unpack(form, self.stream.read(width))
            content = self.stream.read(size)
            if first & 15 == PING:
                self._frame(PONG, content)
            else:
                text += content
                if first & 128:
                    return json.loads(text)
