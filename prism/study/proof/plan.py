"""What is proved, and in which scenes."""

from dataclasses import dataclass

CLOCKWORK = ("drains", "swaps")
"""Liveness properties, which Spin checks under weak fairness."""

PROPERTIES = {
    "record": "the record is the device's state whenever nothing is in transit and no doubt is declared",
    "once": "every observed occurrence ends in exactly one way",
    "visit": "no occurrence of an earlier visit is begun",
    "again": "after a crash no step that was begun is sent a second time, and no plan is made again",
    "sent": "a step is only sent when the record is at the step's source state",
    "stuck": "when nothing waits, a visit is in progress, or the new model is about to follow the device",
    "room": "a controller's event is lost only when the queue is full of controllers' events",
    "together": "when nothing is left to do, device and new model go together, unless something failed",
    "question": "nothing else has its turn before the device is asked where it is",
    "heard": "no request has its turn, or is decided, while a fact waits",
    "needed": "when nothing is left to do, the device is where the new model's state needs it, even after a failure",
    "reached": "a request that leads to a state which needs the device somewhere has taken the device there",
    "starts": "the function of such a state is started only while the device is there for certain, and no fact waits",
    "runs": "when nothing is left to do, the function of such a state runs",
    "resumes": "a transition to such a state whose last answer was lost is taken if the device is found there",
    "urgent": "an urgent event is never lost, and no other request has its turn, is decided or sends a step while it waits",
    "another": "what waits to be decided again is not taken for another press: the new model does not follow what that has done",
    "drains": "when nothing more happens, the queue drains",
    "swaps": "every swap ends: it is completed or abandoned",
}
NUMBERS = ("", "record", "once", "visit", "again", "sent", "stuck", "room", "together", "question", "heard",
           "needed", "reached", "starts", "runs", "resumes", "urgent", "another")  # fmt: skip
"""The properties, by their numbers in prism/proof/core.pml."""


@dataclass(frozen=True)
class Pair:
    """Two models, the new models that may replace them, and what the converter's program adds."""

    name: str
    key: str
    arguments: tuple[str, ...]


ROBOT = Pair(
    "cleaning robot",
    "robot",
    (
        "--original", "models/cleaning-robot.xml#original",
        "--new", "models/cleaning-robot.xml#new",
        "--next", "models/cleaning-robot-twice.scxml",
        "--sendable", "Clean,Spot",
        "--spontaneous", "endSpot,Clean,Spot",
        "--timer", "SpotWait=timeout",
    ),
)  # fmt: skip
BULB = Pair(
    "light bulb",
    "bulb",
    (
        "--original", "models/light-bulb.xml#original",
        "--new", "models/light-bulb.xml#new",
        "--next", "models/light-bulb.xml#original",
        "--mapping", "prism/proof/light-bulb.mapping.txt",
        "--sendable", "switch",
        "--spontaneous", "switch",
        "--timer", "wait=timeout",
    ),
)  # fmt: skip
FAN = Pair(
    "fan",
    "fan",
    (
        "--original", "prism/proof/fan/original.scxml",
        "--new", "prism/proof/fan/new.scxml",
        "--next", "prism/proof/fan/original.scxml",
        "--mapping", "prism/proof/fan/mapping.txt",
        "--sendable", "power",
        "--pressed", "boost",
        "--spontaneous", "power",
        "--timer", "Boost=timeout",
    ),
)  # fmt: skip
LIFT = Pair(
    "elevator",
    "lift",
    (
        "--original", "prism/proof/lift/original.scxml",
        "--new", "prism/proof/lift/new.scxml",
        "--next", "prism/proof/lift/original.scxml",
        "--mapping", "prism/proof/lift/mapping.txt",
        "--sendable", "up,down",
        "--pressed", "express,fire",
        "--spontaneous", "down",
        "--timer", "Alarm=timeout",
        "--queue", "1",
    ),
)  # fmt: skip
PAPERS_PAIRS = (ROBOT, BULB)
PAIRS = (*PAPERS_PAIRS, FAN, LIFT)

ACTS = {
    "PRESSES": "events of a controller",
    "OWNS": "actions of the device",
    "JUMPS": "findings in another state",
    "RAISES": "events of functions",
    "ASKS": "steps requested by functions",
    "STOPS": "stops",
    "FAILS": "failures",
    "GIVE_UPS": "components abandoned",
    "ENDS": "crashes",
    "SWAPS": "swaps",
    "CHANGES": "exchanges",
}

Acts = dict[str, int]

SCENES: tuple[Acts, ...] = (
    {"PRESSES": 3, "OWNS": 3},
    {"PRESSES": 2, "OWNS": 2, "GIVE_UPS": 2},
    {"PRESSES": 2, "OWNS": 2, "STOPS": 2},
    {"PRESSES": 2, "OWNS": 1, "JUMPS": 1, "GIVE_UPS": 1},
    {"PRESSES": 3, "OWNS": 1, "RAISES": 2},
    {"PRESSES": 2, "OWNS": 1, "RAISES": 1, "ENDS": 2},
    {"PRESSES": 2, "OWNS": 1, "RAISES": 1, "SWAPS": 2},
    {"PRESSES": 1, "OWNS": 1, "ASKS": 1, "FAILS": 1, "GIVE_UPS": 1, "CHANGES": 1},
    {"PRESSES": 1, "OWNS": 1, "GIVE_UPS": 1, "ENDS": 1, "SWAPS": 1},
)

LIVE_SCENES: tuple[tuple[str, Acts], ...] = (
    ("drains", {"PRESSES": 2, "OWNS": 1, "GIVE_UPS": 1, "STOPS": 1}),
    ("drains", {"PRESSES": 1, "OWNS": 1, "RAISES": 1, "FAILS": 1, "ENDS": 1}),
    ("swaps", {"PRESSES": 2, "OWNS": 1, "GIVE_UPS": 1, "SWAPS": 2}),
)

DEVICE_STATE_SCENES: tuple[tuple[str, Acts], ...] = (
    ("resumes", {"PRESSES": 1, "OWNS": 1, "JUMPS": 1, "ENDS": 1}),
    ("another", {"PRESSES": 1, "OWNS": 1, "JUMPS": 1}),
)
"""Those of the fan in which a report of the device's state counts besides its answer."""

URGENT_SCENES: tuple[tuple[str, Acts], ...] = (
    ("", {"PRESSES": 3, "OWNS": 2}),
    ("", {"PRESSES": 3, "OWNS": 1, "STOPS": 1}),
    ("", {"PRESSES": 3, "OWNS": 1, "GIVE_UPS": 1}),
    ("", {"PRESSES": 2, "OWNS": 1, "JUMPS": 1, "FAILS": 1}),
    ("", {"PRESSES": 2, "OWNS": 1, "RAISES": 1, "ASKS": 1}),
    ("", {"PRESSES": 3, "OWNS": 1, "ENDS": 1}),
    ("", {"PRESSES": 2, "OWNS": 1, "SWAPS": 2}),
    ("drains", {"PRESSES": 3, "OWNS": 1}),
    ("drains", {"PRESSES": 2, "FAILS": 1, "ENDS": 1}),
)
"""Those of the elevator: at least one event of a controller is under way, or waits, when the urgent one comes."""


def scenes(pair: Pair) -> list[tuple[str, Acts]]:
    """What is searched, with the property if it is only one. A press of the fan is two steps: where one may be lost, it is enough."""
    if pair is LIFT:
        return list(URGENT_SCENES)
    safe = [{**acts, "PRESSES": 1} if pair is FAN and {"GIVE_UPS", "ENDS"} & acts.keys() else acts for acts in SCENES]
    return [*(("", acts) for acts in safe), *LIVE_SCENES, *(DEVICE_STATE_SCENES if pair is FAN else ())]


@dataclass(frozen=True)
class Adapter:
    """What an adapter reveals about its device."""

    name: str
    meaning: str
    definitions: tuple[str, ...]


BEST = Adapter(
    "best",
    "effects are reported in order with the device's own actions, and the device can report its state",
    ("-DIN_ORDER", "-DCAN_LOCATE=1"),
)
WORST = Adapter("worst", "neither", ("-DCAN_LOCATE=0",))
UNORDERED = Adapter("unordered", "only the latter", ("-DCAN_LOCATE=1",))
ADAPTERS = (BEST, WORST)


@dataclass(frozen=True)
class Mutant:
    """A removed mechanism, the scene, and the property that then fails."""

    name: str
    mechanism: str
    broken: str
    pair: Pair
    acts: Acts
    adapter: Adapter = BEST
    in_core: bool = True
    """Whether org.evoloop.engine's own tests have the same mutation, and a trail shows that it makes a difference."""


MUTANTS = (
    Mutant("FACTS_WAIT_FOR_THEIR_TURN", "a fact moves the record when it is observed", "record", ROBOT, {"OWNS": 1}),
    Mutant("A_CLOSED_CONVERTER_HEARS_NO_FACTS", "facts are accepted while the converter is stopped", "record", ROBOT, {"OWNS": 1}),
    Mutant("GIVING_UP_LEAVES_NO_DOUBT", "an abandoned step leaves a doubt", "record", BULB, {"PRESSES": 1, "GIVE_UPS": 1}),
    Mutant("THE_ORDER_IS_NEVER_IN_DOUBT", "an unknown order leaves a doubt", "record", ROBOT, {"PRESSES": 1, "JUMPS": 1}, UNORDERED),
    Mutant("WHAT_HAPPENS_DURING_A_STEP_IS_FORGOTTEN", "the device's actions during a step are recorded", "record", BULB, {"PRESSES": 1, "OWNS": 1}),
    Mutant("AN_ANSWER_COUNTS_HOWEVER_OLD_IT_IS", "an outdated answer is requested again", "record", BULB, {"PRESSES": 1, "OWNS": 1, "GIVE_UPS": 1}),
    Mutant("AN_END_LEAVES_NO_DOUBT", "a step in transit when the process ends leaves a doubt", "record", BULB, {"PRESSES": 1, "ENDS": 1}),
    Mutant("OTHER_MODELS_BEGIN_WHERE_THEY_WOULD_INITIALLY", "a swap keeps the record", "record", ROBOT, {"OWNS": 1, "SWAPS": 1}),
    Mutant("NO_BACK_PRESSURE", "a step waits until the device is ready", "record", BULB, {"PRESSES": 2}, in_core=False),
    Mutant("CLOSING_DISCARDS_FACTS", "a stop discards no facts", "once", ROBOT, {"OWNS": 1, "STOPS": 1}),
    Mutant("AN_END_FORGETS_WHAT_WAITS", "the journal keeps waiting occurrences", "once", BULB, {"PRESSES": 1, "ENDS": 1}),
    Mutant("AN_END_FORGETS_WHAT_IS_IN_PROGRESS", "the journal keeps the occurrence in progress", "once", ROBOT, {"PRESSES": 1, "ENDS": 1}),
    Mutant("OTHER_MODELS_FORGET_WHAT_WAITS", "a swap keeps waiting occurrences", "once", ROBOT, {"PRESSES": 1, "SWAPS": 1}),
    Mutant("VISITS_ARE_NOT_TOLD_APART", "occurrences of a former visit are stale", "visit", ROBOT, {"PRESSES": 1, "RAISES": 1}),
    Mutant("A_STEP_IS_WRITTEN_DOWN_AFTER_IT_WAS_SENT", "a step is journaled before it is sent", "again", BULB, {"PRESSES": 1, "ENDS": 1}),
    Mutant("AN_INTERRUPTED_PLAN_IS_MADE_ANEW", "an interrupted plan continues where it stopped", "again", BULB, {"PRESSES": 1, "ENDS": 1}),
    Mutant("AN_OVERTAKEN_STEP_IS_SENT_ALL_THE_SAME", "an overtaken plan is made again", "sent", BULB, {"PRESSES": 1, "OWNS": 1}),
    Mutant("A_STATE_IS_NOT_ENTERED_AGAIN", "a state that could not be left is entered again", "stuck", ROBOT, {"PRESSES": 1, "FAILS": 1}),
    Mutant("FACTS_TAKE_UP_CONTROLLERS_PLACES", "facts take up none of the controllers' places", "room", ROBOT, {"PRESSES": 1, "OWNS": 2}),
    Mutant("A_LATE_EFFECT_MOVES_THE_DEVICE_ONLY", "the new model follows a late effect", "together", ROBOT, {"PRESSES": 1, "GIVE_UPS": 1}),
    Mutant("AN_ANSWER_MOVES_THE_DEVICE_ONLY", "the new model follows the device's answer, after older facts", "together", BULB, {"PRESSES": 1, "OWNS": 1, "GIVE_UPS": 1}),
    Mutant("WHAT_IS_DECIDED_AGAIN_COMES_BEFORE_A_QUESTION", "the device is asked before an overtaken plan is made again", "question", BULB, {"PRESSES": 2, "OWNS": 1, "JUMPS": 1, "GIVE_UPS": 1}, WORST, in_core=False),
    Mutant("FACTS_WAIT_BEHIND_REQUESTS", "a fact has its turn before any request", "heard", ROBOT, {"PRESSES": 1, "OWNS": 1}, in_core=False),
    Mutant("A_REQUEST_THAT_HAS_BEGUN_IS_DECIDED_BEFORE_FACTS", "a request gives way to a fact until it is decided", "heard", ROBOT, {"PRESSES": 1, "OWNS": 1}),
    Mutant("A_FACT_THAT_FAILS_MOVES_THE_DEVICE_ONLY", "the new model follows a fact that fails before it is decided", "together", ROBOT, {"OWNS": 1, "FAILS": 1}),
    Mutant("A_SWAP_LEAVES_THE_STATES_APART", "after a swap the new model follows what the device has done", "together", BULB, {"PRESSES": 1, "OWNS": 1, "SWAPS": 1}),
    Mutant("A_NEW_STATE_SENDS_NOTHING", "a new state that needs the device somewhere takes it there", "reached", FAN, {"PRESSES": 1}, in_core=False),
    Mutant("A_DEVICE_ELSEWHERE_IS_NOT_FOLLOWED", "what ends with the device elsewhere has the new model follow", "needed", FAN, {"PRESSES": 1, "FAILS": 1}),
    Mutant("A_FUNCTION_IS_STARTED_AT_ONCE", "the start of a function waits until the device is there for certain", "starts", FAN, {"PRESSES": 1, "GIVE_UPS": 1}, in_core=False),
    Mutant("A_START_THAT_HAS_TO_WAIT_IS_FORGOTTEN", "a start that has to wait is owed", "runs", FAN, {"PRESSES": 1, "GIVE_UPS": 1}),
    Mutant("A_DOUBT_FORGETS_ITS_DECISION", "a doubt remembers the decision that it interrupted", "resumes", FAN, {"PRESSES": 1, "ENDS": 1}),
    Mutant("A_QUESTION_FORGETS_WHAT_A_REPORT_COMPLETES", "a question that a report has answered decides nothing", "resumes", FAN, {"PRESSES": 1, "JUMPS": 1, "ENDS": 1}),
    Mutant("WHAT_IS_DECIDED_AGAIN_IS_TAKEN_FOR_ANOTHER_PRESS", "the new model does not follow what waits to be decided again", "another", FAN, {"PRESSES": 1, "JUMPS": 1}, UNORDERED, in_core=False),
    Mutant("WHAT_IS_URGENT_HAS_NO_PLACE_OF_ITS_OWN", "an urgent event has a place of its own", "urgent", LIFT, {"PRESSES": 2}),
    Mutant("WHAT_IS_URGENT_WAITS_FOR_ITS_TURN", "an urgent event has its turn before other requests", "urgent", LIFT, {"PRESSES": 3}, in_core=False),
    Mutant("A_REQUEST_THAT_HAS_BEGUN_IS_DECIDED_BEFORE_WHAT_IS_URGENT", "a request gives way to an urgent event until it is decided", "urgent", LIFT, {"PRESSES": 2}),
    Mutant("A_PLAN_GOES_ON_WHILE_WHAT_IS_URGENT_WAITS", "an urgent event ends a plan between two steps", "urgent", LIFT, {"PRESSES": 2}),
    Mutant("NOBODY_IS_ASKED_TO_GO_ON", "each step that took effect requests the next", "drains", ROBOT, {"PRESSES": 1}, in_core=False),
    Mutant("A_SWAP_HAS_NO_DEADLINE", "a swap that has to wait is abandoned eventually", "swaps", BULB, {"PRESSES": 1, "OWNS": 1, "GIVE_UPS": 1, "SWAPS": 1}, WORST, in_core=False),
)  # fmt: skip

PAPER: tuple[tuple[str, Acts], ...] = (
    ("record", {"PRESSES": 3}),
    ("once", {"PRESSES": 2}),
    ("visit", {"PRESSES": 2, "RAISES": 1}),
    ("again", {"PRESSES": 1, "ENDS": 1}),
    ("drains", {"PRESSES": 2}),
    ("swaps", {"PRESSES": 2, "SWAPS": 1}),
)
"""The properties checked for the paper's mechanism; the others are about mechanisms that it does not have."""


def words(acts: Acts) -> str:
    return ", ".join(f"{count} {ACTS[act] if count > 1 else _one(ACTS[act])}" for act, count in acts.items())


def _one(many: str) -> str:
    noun, *rest = many.split(" ", 1)
    return " ".join([noun.removesuffix("es") if noun == "crashes" else noun.removesuffix("s"), *rest])
