"""Mistakes of a user."""


class Problem(Exception):
    """A mistake that a user can fix; the message says what and how. The status is what the program exits with."""

    def __init__(self, message: str, status: int = 1) -> None:
        super().__init__(message)
        self.status = status
