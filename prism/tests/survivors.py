"""Why some mutants change no value: what they change never comes about, or means the same."""

import re
from dataclasses import dataclass

from tests.mutants import Mutant


@dataclass(frozen=True)
class Survivor:
    """Mutants that survive with good reason: those of these files whose line and change match."""

    files: str
    line: str
    change: str
    reason: str

    def explains(self, file: str, mutant: Mutant) -> bool:
        return bool(
            re.fullmatch(self.files, file)
            and re.search(self.line, mutant.context)
            and re.fullmatch(self.change, f"{mutant.old.strip()} > {mutant.new.strip()}", re.DOTALL)
        )


_ANY = ".*"

SURVIVORS = (
    Survivor("baseline.*", r"^\[(control|process)]", r"(\w+) > \1_else", "no other module knows the action"),
    Survivor("(exact|fifo-serial|holdoff|listing).sm", r"^\[process]", r"process > process_else", "the same"),
    Survivor("(fifo-pipelined|path).sm", r"^\[hold]", "hold > hold_else", "the same"),
    Survivor("holdoff.sm", r"^\[(convert|pass)]", r"(\w+) > \1_else", "the same"),
    Survivor("listing.sm", r"^\[arrived]", "arrived > arrived_else", "the same"),
    Survivor("wait-serial.sm", r"^\[process]", "process > process_else", "the same"),
    Survivor("baseline.*|listing.sm", "!(emb_controlled|arrived) ->", "!.* > true", "what is true already becomes true"),
    Survivor("listing.sm", "conv_st", _ANY, "the paper's listing counts what was sent, and nothing asks for it"),
    Survivor(
        "(fifo-.*|path).sm",
        r"^\[control] +emb_controlled (-> 1 : true|: 1);",
        _ANY,
        "the converter never hands over to a device that acts; a mutant that does is noticed",
    ),
    Survivor("(fifo-.*|path).sm", r"^\[control] !emb_controlled -> 1", "!emb_controlled > true", "the same"),
    Survivor(
        "(fifo-pipelined|path|wait-pipelined).sm",
        r"^\[next] +emb_controlled",
        r"emb_controlled( & .*)? > (part.*|true)",
        "an event is held only while the device acts",
    ),
    Survivor("wait-.*.sm", r"^\[over]", _ANY, "once the event is handed over nothing else is asked for"),
    Survivor("wait-.*.sm", r"^\[(hold|control)] +left>0", r"left>0.* > .*|> > >=|0 > -1|& > \|", "the same"),
    Survivor("wait-.*.sm", r"^\[process]", "emb_controlled > true", "a device at rest comes to rest"),
    Survivor(
        "wait-pipelined.sm",
        r"^\[next]",
        r"next > next_else|\[next] +emb_controlled.* > ",
        "the device's action takes 1 s, and so does the converter's command by itself; the device stays as it is",
    ),
    Survivor("(belief|paper|wait).props", "<=", "<= > <", "nothing happens at a certain moment of continuous time"),
)
