"""A table of the report."""
from dataclasses import dataclass
from html import escape


@dataclass(frozen=True)
class Failing:
    """A cell that is marked."""

    text: str


def table(head, rows):
    cells = "".join(f"<th>{escape(str(cell))}</th>" for cell in head)
    lines = "".join("<tr>" + "".join(_cell(c) for c in row) + "</tr>" for row in rows)
    return f"<table><tr>{cells}</tr>{lines}</table>"


def _cell(cell):
    if isinstance(cell, Failing):
        return f'<td class="failing">{escape(cell.text)}</td>'
    return f"<td>{escape(str(cell))}</td>"


def yes_no(holds):
    return "holds" if holds else "does not hold"
