"""Checks for each model in a directory whether its label "bad" can be reached: prints a line "NAME holds" or "NAME fails"."""

import sys
from pathlib import Path

import stormpy
import stormpy.developer


def fails(model: Path) -> bool:
    program = stormpy.parse_prism_program(str(model))
    question = stormpy.parse_properties('Pmax=? [ F "bad" ]', program)
    built = stormpy.build_model(program, question)
    return float(stormpy.model_checking(built, question[0]).get_value(built.initial_states[0])) > 0.5


def main() -> None:
    stormpy.developer.set_log_level(stormpy.developer.LogLevel.OFF)
    for model in sorted(Path(sys.argv[1]).glob("*.prism")):
        print(model.stem, "fails" if fails(model) else "holds")


if __name__ == "__main__":
    main()
