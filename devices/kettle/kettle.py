"""A simulated kettle that receives and sends lines on its standard input and output: PWR, BOIL, STATE?."""

import sys
import threading

NEXT = {
    ("Off", "PWR"): "Warm",
    ("Warm", "PWR"): "Off",
    ("Warm", "BOIL"): "Boiling",
    ("Boiling", "PWR"): "Off",
}
BOILS_S = 1.0
state = "Off"
boiled = threading.Timer(BOILS_S, print)
lock = threading.Lock()


def say(line: str) -> None:
    print(line, flush=True)


def go(to: str) -> None:
    global state, boiled
    boiled.cancel()
    state = to
    if to == "Boiling":
        boiled = threading.Timer(BOILS_S, done)
        boiled.daemon = True
        boiled.start()


def done() -> None:
    with lock:
        if state == "Boiling":
            go("Warm")
            say("boiled")


for line in sys.stdin:
    word = line.strip()
    with lock:
        if word == "STATE?":
            say("is " + state)
        elif (state, word) in NEXT:
            go(NEXT[state, word])
            say("OK")
        else:
            say("ERR")
