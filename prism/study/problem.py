"""What a user can mend."""


class Problem(Exception):
    """Something that a user can mend; the message says what and how. The status is what the program exits with."""

    def __init__(self, message: str, status: int = 1) -> None:
        super().__init__(message)
        self.status = status
