"""Tables of results as CSV files."""

import csv
from pathlib import Path

Cell = str | float | int | None


class Table:
    """Rows with a header, stored in results/NAME.csv."""

    def __init__(self, name: str, header: tuple[str, ...]) -> None:
        self.name = name
        self.header = header
        self.rows: list[tuple[Cell, ...]] = []

    def add(self, *row: Cell) -> None:
        if len(row) != len(self.header):
            raise ValueError(f"{self.name}: {len(row)} cells for {len(self.header)} columns")
        self.rows.append(row)

    def write(self, folder: Path) -> None:
        with (folder / f"{self.name}.csv").open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.header)
            writer.writerows([_text(cell) for cell in row] for row in self.rows)

    @staticmethod
    def read(name: str, folder: Path) -> "Table | None":
        """A stored table, with numeric cells as numbers; None if there is none."""
        path = folder / f"{name}.csv"
        if not path.is_file():
            return None
        with path.open(encoding="utf-8", newline="") as file:
            header, *rows = csv.reader(file)
        table = Table(name, tuple(header))
        for row in rows:
            table.add(*(_cell(text) for text in row))
        return table


def _cell(text: str) -> Cell:
    if not text:
        return None
    try:
        return float(text) if not text.isdigit() else int(text)
    except ValueError:
        return text


def _text(cell: Cell) -> str:
    if cell is None:
        return ""
    if isinstance(cell, float):
        # The checkers agree to about nine decimal places, so different machines print the same.
        return f"{cell:.9f}".rstrip("0").rstrip(".") if abs(cell) != float("inf") else "inf"
    return str(cell)
