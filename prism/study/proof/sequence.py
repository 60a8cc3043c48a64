"""A Spin trail as a sequence diagram."""

import re
from dataclasses import dataclass
from xml.sax.saxutils import escape

from study.proof.plan import PROPERTIES

_LANES = {"people": 90, "converter": 330, "device": 570}
_TITLES = {"people": "controller, functions", "converter": "converter", "device": "device"}
_ROW = 26
_WIDTH = 680


@dataclass(frozen=True)
class Names:
    """The meaning of the numbers in a specification."""

    device: dict[int, str]
    system: dict[int, str]
    event: dict[int, str]

    @staticmethod
    def of(tables: str) -> "Names":
        kinds: dict[str, dict[int, str]] = {"device": {}, "system": {}, "event": {}}
        for kind, number, name in re.findall(r"^//@ (\w+) (\d+) (.*)$", tables, re.MULTILINE):
            kinds[kind][int(number)] = name
        return Names(**kinds)


@dataclass(frozen=True)
class _Line:
    source: str
    target: str
    text: str
    red: bool = False


def steps(trail: str) -> int:
    """The number of steps in it."""
    return sum(1 for line in trail.splitlines() if line.startswith("= "))


def draw(trail: str, names: Names, title: str, broken: str) -> str:
    """The diagram as SVG."""
    lines = _lines(trail, names, broken)
    height = 92 + _ROW * len(lines)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" height="{height}" viewBox="0 0 {_WIDTH} {height}" '
        'font-family="sans-serif" font-size="12">',
        f"<title>{escape(title)}</title>",
        '<defs><marker id="head" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        '<path d="M0 0 8 4 0 8Z"/></marker></defs>',
        f'<rect width="{_WIDTH}" height="{height}" fill="#fff"/>',
        f'<text x="12" y="20" font-weight="bold">{escape(title)}</text>',
    ]
    for lane, x in _LANES.items():
        parts.append(f'<rect x="{x - 75}" y="32" width="150" height="24" fill="#eef2f7" stroke="#456"/>')
        parts.append(f'<text x="{x}" y="48" text-anchor="middle">{_TITLES[lane]}</text>')
        parts.append(f'<path d="M{x} 56V{height - 10}" stroke="#9ab" stroke-dasharray="3 3"/>')
    for row, line in enumerate(lines):
        parts += _drawn(line, 78 + _ROW * row)
    return "\n".join([*parts, "</svg>"]) + "\n"


def _drawn(line: _Line, y: int) -> list[str]:
    begin, end = _LANES[line.source], _LANES[line.target]
    colour = "#b00020" if line.red else "#123"
    if begin != end:
        return [
            f'<path d="M{begin} {y}H{end}" stroke="{colour}" marker-end="url(#head)"/>',
            f'<text x="{(begin + end) // 2}" y="{y - 4}" text-anchor="middle" fill="{colour}">{escape(line.text)}</text>',
        ]
    width = 7 * len(line.text) + 14
    left = min(max(4, begin - width // 2), _WIDTH - width - 4)
    return [
        f'<rect x="{left}" y="{y - 13}" width="{width}" height="19" rx="3" fill="#fffbe6" stroke="{colour}"/>',
        f'<text x="{left + width // 2}" y="{y + 1}" text-anchor="middle" fill="{colour}">{escape(line.text)}</text>',
    ]


def _lines(trail: str, names: Names, broken: str) -> list[_Line]:
    lines: list[_Line] = []
    state, device = "= 0 1 1", names.device[1]
    for said in trail.splitlines():
        if said.startswith("= "):
            state = said
        elif said.startswith("device "):
            device = names.device[int(said.split()[1])]
        elif "START OF CYCLE" in said:
            lines.append(_Line("converter", "converter", "repeats forever"))
        else:
            line = _told(said, names)
            if line is not None:
                lines.append(line)
    record = names.device[int(state.split()[2])]
    system = names.system[int(state.split()[3])]
    lines.append(_Line("converter", "converter", f"the record: device in {record}, system in {system}"))
    lines.append(_Line("device", "device", f"in {device}"))
    lines.append(_Line("converter", "converter", f"violated: {PROPERTIES[broken]}", red=True))
    return lines


def _told(said: str, names: Names) -> _Line | None:
    words = said.removeprefix("> ").split()
    if not words:
        return None
    number = int(words[1]) if len(words) > 1 and words[1].isdigit() else 0
    event = names.event.get(number, "")
    to_converter = {
        "press": ("people", event),
        "raise": ("people", f"{event} of a function{_former(words)}"),
        "ask": ("people", f"a function requests {event}{_former(words)}"),
        "own": ("device", f"did {event} by itself"),
        "found": ("device", f"is in {names.device.get(number, '')}{' (late)' if words[-1] == '1' else ''}"),
        "sent": ("device", "has obeyed"),
        "located": ("device", _answer(words, names)),
    }
    notes = {
        "failed": "a component fails",
        "given_up": "the component is abandoned",
        "recovered": "the process ends; another one recovers",
        "opened": "started",
        "closing": "stopped",
        "evolved": "other models take over",
        "timer": "a timer is due",
        "changed": "components are exchanged",
    }
    if said.startswith("> ") and words[0] in to_converter:
        source, text = to_converter[words[0]]
        return _Line(source, "converter", text)
    if said.startswith("> sending"):
        return _Line("converter", "device", names.event.get(int(words[2]), ""))
    if said.startswith("> ") and words[0] in notes:
        return _Line("converter", "converter", notes[words[0]])
    if said.startswith("the device"):
        return _Line("device", "device", _device(said.removeprefix("the device "), names))
    return _Line("people", "people", said) if "swap" in said else None


def _answer(words: list[str], names: Names) -> str:
    place = names.device.get(int(words[-1])) if words[-1].isdigit() else None
    return f"is in {place}" if place else "does not know its state"


def _former(words: list[str]) -> str:
    return ", of a former visit" if words[-1] == "2" else ""


def _device(said: str, names: Names) -> str:
    known = names.device if said.startswith(("gets", "answers")) else names.event
    return re.sub(r"\d+", lambda number: known.get(int(number[0]), number[0]), said)
