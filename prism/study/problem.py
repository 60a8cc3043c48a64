"""Users' mistakes."""


class Problem(Exception):
    """A mistake that the user can fix; the message says how. The program exits with the status."""

    def __init__(self, message: str, status: int = 1) -> None:
        super().__init__(message)
        self.status = status
