"""A lamp that knows one command, switch, and has a warm filter that a program can pull in front of it."""

import sys

on = False
for line in sys.stdin:
    word = line.strip()
    if word == "switch":
        on = not on
        print("on" if on else "off", flush=True)
    elif word == "filter":
        print("the filter moves", file=sys.stderr)
    elif word == "?":
        print("on" if on else "off", flush=True)
