"""A Spin trail as a story in words, which the core's tests read (org.evoloop.engine.Trail)."""

from study.proof.sequence import Names

_STAGES = ("READY", "SENDING", "INTERRUPTED", "RESUMED")
_DOUBTS = ("sure", "doubt", "settled", "remembering", "reported")
_OWED = ("-", "owed", "start", "owed-start")


def write(trail: str, names: Names) -> str:
    """One input per line, each followed by what the core then knows."""
    lines: list[str] = []
    numbers: dict[str, int] = {}
    observed = 0
    told = False
    for said in trail.splitlines():
        if said.startswith("new "):
            observed += 1
            numbers[said.split()[1]] = observed
        elif said.startswith("> "):
            lines.append(_input(said[2:].split(), names, numbers))
            told = True
        elif said.startswith("= ") and told:
            lines.append(state(said[2:], names))
            told = False
    return "\n".join(lines) + "\n"


def _input(words: list[str], names: Names, numbers: dict[str, int]) -> str:
    kind, rest = words[0], words[1:]
    if kind == "press":
        return f"press {names.event[int(rest[0])]}"
    if kind == "own":
        return f"own {names.event[int(rest[0])]} {'acted' if rest[1] == '1' else '-'}"
    if kind in ("raise", "ask"):
        return f"{kind} {names.event[int(rest[0])]} {'former' if rest[1] == '2' else 'present'}"
    if kind == "found":
        return f"found {names.device[int(rest[0])]} {'late' if rest[1] == '1' else '-'}"
    if kind == "planned":
        return f"planned {names.device[int(rest[2])]} {names.system[int(rest[3])]}"
    if kind == "sent":
        return f"sent {numbers[rest[0]]} {'in-order' if rest[1] == '1' else '-'}"
    if kind == "located":
        return f"located {names.device.get(int(rest[1]), '-')}"
    return "given-up" if kind == "given_up" else kind


def state(said: str, names: Names) -> str:
    head, *pending = said.split("[")
    core, doubt, work = head.replace("doubt", "|").replace("work", "|").split("|")
    is_open, device, system, _, over, armed, _, owed = core.split()
    busy, decided, _, stage, _, _ = work.split()
    doing = "idle" if busy == "0" else _STAGES[int(stage)] if decided == "1" else "deciding"
    return " ".join(
        (
            "=",
            "open" if is_open == "1" else "closed",
            names.device[int(device)],
            names.system[int(system)],
            _DOUBTS[int(doubt.split()[0])],
            "waiting",
            str(len(pending) - 1),
            doing,
            "over" if over == "1" else "visit",
            "timer" if armed == "1" else "-",
            _OWED[int(owed)],
        )
    )


_WITHOUT_ARGUMENTS = {
    "anew": "ANEW",
    "opened": "OPENED",
    "closing": "CLOSING",
    "closed": "CLOSED",
    "recovered": "RECOVERED",
    "changed": "CHANGED",
    "ready": "READY_FOR",
    "timer": "TIMER_DUE",
    "late-timer": "TIMER_DUE 1",
    "sending": "SENDING_IT",
    "failed": "FAILED",
    "given-up": "GIVEN_UP",
}


def read(line: str, names: Names) -> str:
    """An input in words, in the form that prism/proof/script.pml reads."""
    kind, *rest = line.split()
    if kind in _WITHOUT_ARGUMENTS:
        return _filled(_WITHOUT_ARGUMENTS[kind])
    devices, systems, events = ({name: number for number, name in kinds.items()} for kinds in _kinds(names))
    flag = int(rest[-1] in ("late", "acted", "in-order"))
    visit = 2 if rest[-1] == "former" else 1
    return _filled(
        {
            "press": lambda: f"HEARD_OF {events[rest[0]]} 1 0 0",
            "own": lambda: f"HEARD_OF {events[rest[0]]} 2 0 {flag}",
            "raise": lambda: f"HEARD_OF {events[rest[0]]} 4 {visit} 0",
            "ask": lambda: f"ASKED_OF {events[rest[0]]} {visit}",
            "found": lambda: f"FOUND_AT {devices[rest[0]]} {flag}",
            "planned": lambda: f"PLANNED_IN {devices[rest[0]]} {systems[rest[1]]}",
            "sent": lambda: f"WAS_SENT {rest[0]} {flag}",
            "located": lambda: f"LOCATED 0 {devices.get(rest[0], 0)}",
        }[kind]()
    )


def _kinds(names: Names) -> tuple[dict[int, str], ...]:
    return names.device, names.system, names.event


def _filled(words: str) -> str:
    return " ".join([*words.split(), "0", "0", "0", "0"][:5])
