"""Why some mutants change no value: the changed case never occurs, or is equivalent."""

import re
from dataclasses import dataclass

from tests.mutants import Mutant


@dataclass(frozen=True)
class Survivor:
    """Mutants that survive for a good reason: those of these files whose line and change match."""

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
_DISTURBED = "crash|phases|sight|swap"

SURVIVORS = (
    Survivor("baseline.*", r"^\[(control|process)]", r"(\w+) > \1_else", "no other module has the action"),
    Survivor("(exact|fifo-serial|holdoff|listing).sm", r"^\[process]", r"process > process_else", "the same"),
    Survivor(f"(fifo-pipelined|path|{_DISTURBED}).sm", r"^\[(hold|on)]", r"(\w+) > \1_else", "the same"),
    Survivor("holdoff.sm", r"^\[(convert|pass)]", r"(\w+) > \1_else", "the same"),
    Survivor("listing.sm", r"^\[arrived]", "arrived > arrived_else", "the same"),
    Survivor("wait-serial.sm", r"^\[process]", "process > process_else", "the same"),
    Survivor("baseline.*|listing.sm", "!(emb_controlled|arrived) ->", "!.* > true", "a true variable is set to true"),
    Survivor("listing.sm", "conv_st", _ANY, "the paper's listing counts the events sent, but no property uses the count"),
    Survivor(
        f"(fifo-.*|path|{_DISTURBED}).sm",
        r"^\[control] +emb_controlled (-> 1 : true|: 1);",
        _ANY,
        "the converter never hands over to a device that acts; a mutant that does is noticed",
    ),
    Survivor(f"(fifo-.*|path|{_DISTURBED}).sm", r"^\[control] !emb_controlled -> 1", "!emb_controlled > true", "the same"),
    Survivor(
        f"(fifo-pipelined|path|wait-pipelined|{_DISTURBED}).sm",
        r"^\[next] +emb_controlled",
        r"emb_controlled( & .*)? > (part.*|true)",
        "an event is held only while the device acts",
    ),
    Survivor("sight.sm", r"^\[gone]|^\[(found|again)] !in_sight", r"(\w+) > \1_else|!?in_sight > true", "the same"),
    Survivor("sight.sm", r"^\[moved]", r"\+ > -|1 > 2", "a ring that turns the other way diverges as often"),
    Survivor("crash.sm", r"^\[(crash|recovered)]", r"(\w+) > \1_else", "the same"),
    Survivor("crash.sm", r"^\[crash]", "up & journal=[01] > journal=[01]", "a process that is not running cannot end"),
    Survivor("crash.sm", r"^\[recovered]", "!up > true", "a running process is not started"),
    Survivor("swap.sm", r"^\[(ask|swapped)]", r"(\w+) > \1_else", "the same"),
    Survivor("phases.sm", r"^phase :", "1 > 2", "a phase that is never reached"),
    Survivor("wait-.*.sm", r"^\[over]", _ANY, "after the event is handed over no property is evaluated"),
    Survivor("wait-.*.sm", r"^\[(hold|control)] +left>0", r"left>0.* > .*|> > >=|0 > -1|& > \|", "the same"),
    Survivor("wait-.*.sm", r"^\[process]", "emb_controlled > true", "a device at rest comes to rest"),
    Survivor(
        "wait-pipelined.sm",
        r"^\[next]",
        r"next > next_else|\[next] +emb_controlled.* > ",
        "the device's action takes 1 s, and so does the converter's command alone; the device's state does not change",
    ),
    Survivor("(belief|handed|paper|wait).props", "<=", "<= > <", "in continuous time, nothing happens at exactly one moment"),
)
